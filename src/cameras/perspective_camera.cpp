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
  const Vec3 offset = OnLens(u);
  ray.origin = center_ + offset;
  ray.direction = Normalize(in_focus - offset);
  return ray;
}

// The image point solves way ~ forward + right x + up y, by Cramer's rule: `up` may be slanted.
std::optional<Vec2> PerspectiveCamera::ImagePointOf(Vec3d way) const {
  const Vec3d forward = ToDouble(forward_), right = ToDouble(right_), up = ToDouble(up_);
  const Vec3d across = Cross(right, up);
  const double determinant = Dot(forward, across);
  const double depth = Dot(way, across) / determinant;
  if (!(depth > 0)) return std::nullopt;
  return Vec2{static_cast<float>(Dot(way, Cross(up, forward)) / (determinant * depth)),
              static_cast<float>(Dot(way, Cross(forward, right)) / (determinant * depth))};
}

// With d = forward + right x + up y and D = |det(forward, right, up)|, a part dx dy of the image
// plane is seen from the centre under the solid angle D / |d|^3 dx dy. On the plane in focus, at
// the distance f along the unit direction of view v, it covers the area D f^2 / (d.v)^3 dx dy,
// which a point of the lens sees along w, of any length, under the solid angle
// D (w.v)^3 / (|w| (d.v))^3 dx dy.
std::optional<CameraConnection> PerspectiveCamera::Connect(Vec3 p, Vec2 u) const {
  Vec3d way = ToDouble(p) - ToDouble(center_);
  const Vec3d view = ToDouble(view_);
  // What is not ahead of the lens is seen through its middle only; see `GenerateRay`.
  const bool has_lens = !IsPinhole() && Dot(way, view) > 0;
  Vec3d seen = way;
  if (has_lens) {
    const Vec3d offset = ToDouble(OnLens(u));
    way = way - offset;
    seen = offset + way * (double{focus_distance_} / Dot(way, view));
  }
  const std::optional<Vec2> image_point = ImagePointOf(seen);
  const double distance = Length(way);
  if (!image_point || !(distance > 0)) return std::nullopt;

  const Vec3d d = ToDouble(forward_) + ToDouble(right_) * double{image_point->x} +
                  ToDouble(up_) * double{image_point->y};
  const double determinant =
      std::abs(Dot(ToDouble(forward_), Cross(ToDouble(right_), ToDouble(up_))));
  const double stretch = has_lens ? distance * Dot(d, view) / Dot(way, view) : Length(d);
  CameraConnection connection;
  connection.direction = ToFloat(way * (-1 / distance));
  connection.distance = static_cast<float>(distance);
  connection.image_point = *image_point;
  connection.importance =
      static_cast<float>(stretch * stretch * stretch / (determinant * distance * distance));
  return connection;
}

Vec3 PerspectiveCamera::OnLens(Vec2 u) const {
  const Vec2 on_lens = SampleLens(u);
  return lens_x_ * on_lens.x + lens_y_ * on_lens.y;
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
