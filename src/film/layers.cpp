#include "film/layers.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "film/film.h"

namespace candela {
namespace {

// What compositors that others write for take for nothing: far away, but a number that can be
// shown. Infinity spoils every filter that it gets into.
constexpr float kDepthOfNothing = 1e10f;

/// What is recorded may be infinite or no number where the radiance is neither: a colour of 0 can
/// hide it. Then it counts as the largest term of the colours, or as nothing.
Vec3d Usable(Rgb value) {
  const auto usable = [](float x) {
    const float limited = std::clamp(x, -ExactSum::kLargestTerm, ExactSum::kLargestTerm);
    return double{limited == limited ? limited : 0};
  };
  return {usable(value.x), usable(value.y), usable(value.z)};
}

Rgb MeanOf(Vec3d sum, const PixelSums& pixel) {
  const double divisor = pixel.weight.ToDouble();
  return divisor == 0 ? Rgb() : ToFloat(sum / divisor);
}

void Put(Vec3 value, uint32_t* words) {
  words[0] = std::bit_cast<uint32_t>(value.x);
  words[1] = std::bit_cast<uint32_t>(value.y);
  words[2] = std::bit_cast<uint32_t>(value.z);
}

constexpr LayerEntry kLayers[] = {
    {"depth", "Z", false, "distance along the camera's view, 1e10 where nothing is",
     [](const PixelLayers& l, const PixelSums&, uint32_t* words) {
       const SampleLayers::Surface& seen = l.Surface();
       *words = std::bit_cast<uint32_t>(seen.object == 0 ? kDepthOfNothing : seen.depth);
     }},
    {"position", "XYZ", false, "point in the world",
     [](const PixelLayers& l, const PixelSums&, uint32_t* words) {
       Put(l.Surface().position, words);
     }},
    {"normal", "XYZ", false, "normal as shaded, in the world, towards the camera",
     [](const PixelLayers& l, const PixelSums&, uint32_t* words) {
       Put(l.Surface().n_shading, words);
     }},
    {"geometric_normal", "XYZ", false, "normal of the true surface",
     [](const PixelLayers& l, const PixelSums&, uint32_t* words) {
       Put(l.Surface().n_geometric, words);
     }},
    {"albedo", "RGB", false, "part of white light that the surface gives back",
     [](const PixelLayers& l, const PixelSums& sums, uint32_t* words) {
       Put(l.MeanAlbedo(sums), words);
     }},
    {"uv", "UV", false, "texture coordinates",
     [](const PixelLayers& l, const PixelSums&, uint32_t* words) {
       words[0] = std::bit_cast<uint32_t>(l.Surface().uv.x);
       words[1] = std::bit_cast<uint32_t>(l.Surface().uv.y);
     }},
    {"object_id", "X", true, "number of the object from 1 on, 0 where nothing is",
     [](const PixelLayers& l, const PixelSums&, uint32_t* words) { *words = l.Surface().object; }},
    {"material_id", "X", true, "number of the material, the same way",
     [](const PixelLayers& l, const PixelSums&, uint32_t* words) {
       *words = l.Surface().material;
     }},
    {"direct", "RGB", false, "light scattered once",
     [](const PixelLayers& l, const PixelSums& sums, uint32_t* words) {
       Put(l.MeanLight(sums, 1), words);
     }},
    {"indirect", "RGB", false, "light scattered more often",
     [](const PixelLayers& l, const PixelSums& sums, uint32_t* words) {
       Put(l.MeanLight(sums, 2), words);
     }},
    {"emission", "RGB", false, "lamps and sky as the camera sees them",
     [](const PixelLayers& l, const PixelSums& sums, uint32_t* words) {
       Put(l.MeanLight(sums, 0), words);
     }},
    {"sample_count", "X", true, "samples that count",
     [](const PixelLayers& l, const PixelSums&, uint32_t* words) { *words = l.SampleCount(); }},
    {"standard_error", "RGB", false, "standard error of the colour",
     [](const PixelLayers& l, const PixelSums& sums, uint32_t* words) {
       Put(l.StandardError(sums), words);
     }},
};

}  // namespace

std::span<const LayerEntry, kLayerCount> Layers() {
  return kLayers;
}

bool PixelLayers::IsNearest(float distance, uint32_t index) {
  const bool is_nearest =
      !has_nearest_ || distance < distance_ || (distance == distance_ && index < index_);
  if (is_nearest) {
    has_nearest_ = true;
    distance_ = distance;
    index_ = index;
  }
  return is_nearest;
}

void PixelLayers::Add(const SampleLayers& sample, Rgb radiance, float weight) {
  ++count_;
  albedo_ += Usable(sample.albedo * weight);
  for (size_t i = 0; i < light_.size(); ++i) light_[i] += Usable(sample.light[i] * weight);
  const Vec3d weighted = ToDouble(radiance * weight);
  squares_ += weighted * weighted;
  if (weight != 1) {
    weighted_excess_ += weighted * (double{weight} - 1);
    weight_excess_ += double{weight} * (double{weight} - 1);
  }
}

Rgb PixelLayers::MeanAlbedo(const PixelSums& sums) const {
  return MeanOf(albedo_, sums);
}

Rgb PixelLayers::MeanLight(const PixelSums& sums, size_t times_scattered) const {
  return MeanOf(light_[times_scattered], sums);
}

// The pixel is sum(w L) / sum(w). Its variance is n / (n - 1) times the sum of w^2 (L - mean)^2
// over the square of sum(w): W. Cochran, "Sampling techniques", 1977, for the mean of a ratio.
Rgb PixelLayers::StandardError(const PixelSums& sums) const {
  const double weight = sums.weight.ToDouble();
  if (count_ < 2 || weight == 0) return {};
  const double correction = static_cast<double>(count_) / (count_ - 1);
  const double weight_squares = weight + weight_excess_;
  const auto error = [&](int i, const ExactSum& sum) {
    const double mean = sum.ToDouble() / weight;
    const double weighted = sum.ToDouble() + weighted_excess_[i];
    const double spread = squares_[i] - 2 * mean * weighted + mean * mean * weight_squares;
    return std::sqrt(correction * std::max(0.0, spread)) / std::abs(weight);
  };
  return ToFloat({error(0, sums.red), error(1, sums.green), error(2, sums.blue)});
}

}  // namespace candela
