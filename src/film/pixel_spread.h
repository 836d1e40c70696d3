#pragma once

#include <cstdint>

#include "film/pixel_sums.h"

namespace candela {

/// What has to be known of a pixel's samples beside their sums to tell how far its colour may be
/// off. The samples of a pixel come in their order, whoever renders it, so that plain sums are
/// always the same: exact ones take twice as long.
class PixelSpread {
 public:
  /// Adds a sample that the sums have taken.
  void Add(Rgb radiance, float weight) {
    ++count_;
    const Vec3d weighted = ToDouble(radiance * weight);
    squares_ += weighted * weighted;
    if (weight != 1) {
      weighted_excess_ += weighted * (double{weight} - 1);
      weight_excess_ += double{weight} * (double{weight} - 1);
    }
  }

  uint32_t SampleCount() const { return count_; }

  /// The square of the standard error of the weighted mean, from the spread of its samples as if
  /// they were independent. 0 for fewer than two.
  Vec3d Variance(const PixelSums& sums) const;

 private:
  Vec3d squares_;  ///< Of weight^2 L^2.
  // By how much the sums of weight^2 L and of weight^2 exceed those of the pixel, of weight L and
  // of weight: nothing for most filters, whose samples all weigh 1.
  Vec3d weighted_excess_;
  double weight_excess_ = 0;
  uint32_t count_ = 0;
};

}  // namespace candela
