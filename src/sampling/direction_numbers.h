#pragma once

#include "math/vec.h"
#include "sampling/warp.h"

namespace candela {

/// Two numbers in [0, 1) to draw a direction with. Who has drawn many of them together may know
/// already what the cosine map makes of them, which takes a fraction of the time.
class DirectionNumbers {
 public:
  DirectionNumbers(float x, float y) : u_{x, y} {}
  DirectionNumbers(Vec2 u) : u_(u) {}
  DirectionNumbers(Vec2 u, Vec3 on_cosine_hemisphere) : u_(u), known_(on_cosine_hemisphere) {}

  Vec2 u() const { return u_; }
  /// See `SampleCosineHemisphere`.
  Vec3 OnCosineHemisphere() const { return known_.z >= 0 ? known_ : SampleCosineHemisphere(u_); }

 private:
  Vec2 u_;
  Vec3 known_{0, 0, -1};  ///< Below the horizon where it is not known.
};

}  // namespace candela
