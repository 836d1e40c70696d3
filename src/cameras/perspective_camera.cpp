#include "cameras/perspective_camera.h"

#include <algorithm>
#include <cmath>

#include "math/elementary.h"
#include "sampling/warp.h"

namespace candela {

PerspectiveCamera::PerspectiveCamera(const CameraSpec& spec)
    : center_(spec.center),
      lens_radius_(spec.aperture / 2),
      blades_(spec.blades),
      focus_distance_(spec.focus_distance) {
  const Vec3 direction = NormalizeAnyLength(spec.direction);
  const Vec3 up = NormalizeAnyLength(spec.up);
  const Vec3 right = NormalizeAnyLength(Cross(direction, up));
  // The course has direction / tan + right x + up y. All three are scaled by the same power of two,
  // which changes no digit of the rays but lets the angle be as small as it likes.
  int exponent;
  const double fraction = std::frexp(TanDegrees(spec.fov_degrees / 2.0), &exponent);
  const float scale = std::ldexp(1.0f, exponent);
  forward_ = direction / static_cast<float>(fraction);
  right_ = right * scale;
  up_ = up * scale;
  view_ = direction;
  lens_x_ = right;
  lens_y_ = Cross(right, direction);
}

Ray PerspectiveCamera::GenerateRay(Vec2 image_point, Vec2 u) const {
  Ray ray = GenerateRay(image_point);
  if (IsPinhole()) return ray;
  const float ahead = Dot(ray.direction, view_);
  if (!(ahead > 0))
    return ray;  // A slanted `up` may lead the picture to where nothing is in focus.
  const Vec3 in_focus = ray.direction * (focus_distance_ / ahead);
  const Vec2 on_lens = SampleLens(u);
  const Vec3 offset = lens_x_ * on_lens.x + lens_y_ * on_lens.y;
  ray.origin = center_ + offset;
  ray.direction = Normalize(in_focus - offset);
  return ray;
}

Vec2 PerspectiveCamera::SampleLens(Vec2 u) const {
  if (blades_ == 0) return SampleDisk(u) * lens_radius_;
  // A regular polygon with its corners on the rim of the round opening: one of its triangles around
  // the middle, then a point of that.
  const float scaled = u.x * static_cast<float>(blades_);
  const int blade = std::min(static_cast<int>(scaled), blades_ - 1);
  const Vec2 weights =
      SampleTriangle({std::min(scaled - static_cast<float>(blade), 0x1.fffffep-1f), u.y});
  const auto corner = [this](int i) {
    const double degrees = 90 + 360.0 * i / blades_;  // The first one is on top.
    return Vec2{static_cast<float>(CosDegrees(degrees)), static_cast<float>(SinDegrees(degrees))};
  };
  return (corner(blade) * weights.x + corner(blade + 1) * weights.y) * lens_radius_;
}

}  // namespace candela
