#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>

#include "math/exact_sum.h"
#include "math/spectrum.h"
#include "sampling/sample_layers.h"

namespace candela {

/// What limiting samples has taken away from a picture.
struct ClampLoss {
  uint64_t samples = 0;  ///< That were brighter than the limit.
  ExactSum light, lost;  ///< All channels of all samples, weighted, before; and what went.

  /// The part of the light of the picture that is lost.
  double Share() const {
    const double all = light.ToDouble();
    return all > 0 ? lost.ToDouble() / all : 0;
  }
  ClampLoss& operator+=(const ClampLoss& other) {
    samples += other.samples;
    light += other.light;
    lost += other.lost;
    return *this;
  }
};

/// Limits the radiance of samples: one whose largest channel is above the limit is darkened to it,
/// with its colour and its layers. The mean gets darker and is no longer right; what is lost is
/// counted.
class SampleClamp {
 public:
  explicit SampleClamp(std::optional<float> limit) : limit_(limit) {}

  bool IsOn() const { return limit_.has_value(); }

  /// What to multiply a sample with.
  float Factor(Rgb radiance) const {
    const float largest = std::max({radiance.x, radiance.y, radiance.z});
    return largest > *limit_ ? *limit_ / largest : 1;
  }

  /// Takes note of a sample that came into the picture darkened by `factor`.
  static void Count(Rgb radiance, float factor, float weight, ClampLoss* loss) {
    loss->samples += factor < 1 ? 1 : 0;
    for (int i = 0; i < 3; ++i) {
      loss->light.Add(radiance[i] * weight);
      loss->lost.Add((radiance[i] - radiance[i] * factor) * weight);
    }
  }

 private:
  std::optional<float> limit_;
};

}  // namespace candela
