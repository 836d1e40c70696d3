#include "cameras/lens.h"

#include <algorithm>

#include "math/elementary.h"
#include "sampling/warp.h"

namespace candela {

Lens::Lens(const CameraSpec& spec)
    : axes_(AxesOf(spec)),
      radius_(spec.aperture / 2),
      blades_(spec.blades),
      blade_rotation_(spec.blade_rotation),
      focus_distance_(spec.focus_distance),
      focus_normal_(axes_.z),
      is_tilted_(spec.tilt != Vec2()) {
  if (!is_tilted_) return;
  // Along z it is in focus at F + x tan X + y tan Y.
  const Vec3d slope = ToDouble(axes_.x) * TanDegrees(double{spec.tilt.x}) +
                      ToDouble(axes_.y) * TanDegrees(double{spec.tilt.y});
  focus_normal_ = ToFloat(ToDouble(axes_.z) - slope);
}

Vec3 Lens::PointAt(Vec2 u) const {
  const Vec2 on_lens = Sample(u);
  return axes_.x * on_lens.x + axes_.y * on_lens.y;
}

Vec2 Lens::Sample(Vec2 u) const {
  if (blades_ == 0) return SampleDisk(u) * radius_;
  // A regular polygon with its corners on the rim of the round opening: one of its triangles around
  // the middle, then a point of that.
  const float scaled = u.x * static_cast<float>(blades_);
  const int blade = std::min(static_cast<int>(scaled), blades_ - 1);
  const Vec2 weights =
      SampleTriangle({std::min(scaled - static_cast<float>(blade), 0x1.fffffep-1f), u.y});
  return (Corner(blade) * weights.x + Corner(blade + 1) * weights.y) * radius_;
}

Vec2 Lens::Corner(int i) const {
  // The first one is on top, unless they are turned.
  const double degrees = 90 + 360.0 * i / blades_ + static_cast<double>(blade_rotation_);
  return {static_cast<float>(CosDegrees(degrees)), static_cast<float>(SinDegrees(degrees))};
}

}  // namespace candela
