#pragma once

#include <array>
#include <span>

#include "film/pixel_spread.h"
#include "film/pixel_sums.h"

namespace candela {

class PixelLayers;

/// What was collected of a pixel in one series of samples.
struct PixelPart {
  const PixelSums* sums;
  const PixelSpread* spread;  ///< Null where nobody asks how far the colour may be off.
  const PixelLayers* layers;  ///< Null for a film without layers.
  Vec3d least_variance = {};  ///< What neighbours say of that of the mean.
  /// The weighted sums of the light of each group of lights; empty where nobody asks for them.
  std::span<const Vec3d> light_groups = {};
};

/// What a pixel's samples say of it: one series of them, or the mean of several that know nothing
/// of each other. Those whose weights sum to 0 say nothing.
class PixelEstimate {
 public:
  /// At most two, which have to outlive it.
  explicit PixelEstimate(std::span<const PixelPart> parts);

  Rgb Colour() const;
  /// The standard error of the colour, by what its samples or its neighbours say, whichever is
  /// more.
  Rgb StandardError() const;
  uint32_t SampleCount() const;
  /// What was collected nearest to the middle of the pixel; there have to be layers.
  const PixelLayers& Nearest() const;
  size_t LightGroupCount() const { return light_groups_; }
  /// The mean of a weighted sum that each part with layers holds.
  template <class Sum>
  Rgb Mean(Sum sum_of) const {
    Vec3d mean;
    for (const PixelPart& part : Parts()) mean += Divide(sum_of(part), *part.sums);
    return Average(mean);
  }

 private:
  std::span<const PixelPart> Parts() const { return {parts_.data(), count_}; }
  static Vec3d Divide(Vec3d sum, const PixelSums& sums);
  Rgb Average(Vec3d sum_of_means) const;

  std::array<PixelPart, 2> parts_;
  size_t count_ = 0;
  const PixelLayers* nearest_ = nullptr;
  uint32_t samples_ = 0;
  size_t light_groups_ = 0;
};

}  // namespace candela
