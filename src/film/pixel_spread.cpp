#include "film/pixel_spread.h"

#include <algorithm>

namespace candela {

// The pixel is sum(w L) / sum(w). Its variance is n / (n - 1) times the sum of w^2 (L - mean)^2
// over the square of sum(w): W. Cochran, "Sampling techniques", 1977, for the mean of a ratio.
Vec3d PixelSpread::Variance(const PixelSums& sums) const {
  const double weight = sums.weight.ToDouble();
  if (count_ < 2 || weight == 0) return {};
  const double correction = static_cast<double>(count_) / (count_ - 1);
  const double weight_squares = weight + weight_excess_;
  const auto variance = [&](int i, const ExactSum& sum) {
    const double mean = sum.ToDouble() / weight;
    const double weighted = sum.ToDouble() + weighted_excess_[i];
    const double spread = squares_[i] - 2 * mean * weighted + mean * mean * weight_squares;
    return correction * std::max(0.0, spread) / (weight * weight);
  };
  return {variance(0, sums.red), variance(1, sums.green), variance(2, sums.blue)};
}

}  // namespace candela
