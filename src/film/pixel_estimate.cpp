#include "film/pixel_estimate.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"
#include "film/layers.h"

namespace candela {

PixelEstimate::PixelEstimate(std::span<const PixelPart> parts) : parts_{} {
  CHECK(parts.size() <= parts_.size());
  for (const PixelPart& part : parts) {
    light_groups_ = part.light_groups.size();
    if (part.spread) samples_ += part.spread->SampleCount();
    if (part.layers && (!nearest_ || part.layers->IsNearerThan(*nearest_))) nearest_ = part.layers;
    if (part.sums->weight.ToDouble() != 0) parts_[count_++] = part;
  }
}

Rgb PixelEstimate::Colour() const {
  Vec3d sum;
  for (const PixelPart& part : Parts()) sum += part.sums->PreciseMean();
  return Average(sum);
}

Rgb PixelEstimate::StandardError() const {
  Vec3d variance;
  for (const PixelPart& part : Parts())
    variance += Max(part.spread->Variance(*part.sums), part.least_variance);
  return Average({std::sqrt(variance.x), std::sqrt(variance.y), std::sqrt(variance.z)});
}

uint32_t PixelEstimate::SampleCount() const {
  return samples_;
}

const PixelLayers& PixelEstimate::Nearest() const {
  return *nearest_;
}

Vec3d PixelEstimate::Divide(Vec3d sum, const PixelSums& sums) {
  return sum / sums.weight.ToDouble();
}

Rgb PixelEstimate::Average(Vec3d sum_of_means) const {
  return ToFloat(sum_of_means / static_cast<double>(std::max<size_t>(count_, 1)));
}

}  // namespace candela
