#include "cameras/perspective_camera.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cameras/moving_camera.h"
#include "math/elementary.h"

namespace candela {

PerspectiveCamera::PerspectiveCamera(const CameraSpec& spec)
    : spec_(spec), center_(spec.center), lens_(spec) {
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
  angle_per_unit_ = Length(up_) / Length(forward_);
  if (spec.shift != Vec2()) forward_ += right_ * spec.shift.x + up_ * spec.shift.y;
}

std::unique_ptr<Camera> PerspectiveCamera::Create(ParamReader* params, CameraSpec view) {
  view.fov_degrees = params->RequiredAngle("fov");
  ReadLens(params, &view);
  ReadTilt(params, &view);
  view.shift = params->Pair("shift", {0, 0});
  // Farther out the digits of the rays do not tell pixels apart.
  constexpr float kMostShift = 1000;
  if (!(std::max(std::abs(view.shift.x), std::abs(view.shift.y)) <= kMostShift)) {
    params->Error(params->Where("shift"),
                  fmt::format("'shift' expects two numbers between -{0} and {0}, found '{1} {2}'",
                              kMostShift, view.shift.x, view.shift.y));
    view.shift = {};
  }
  return std::make_unique<PerspectiveCamera>(view);
}

std::unique_ptr<Camera> PerspectiveCamera::Moving(const CameraMotion& motion) const {
  return std::make_unique<MovingCamera<PerspectiveCamera>>(*this, motion);
}

std::string PerspectiveCamera::Description() const {
  return fmt::format("{}, {:.6g} degrees", DescribeView(spec_), spec_.fov_degrees);
}

// Written in place, member by member: a ray that is made elsewhere and copied would wait for its
// own members to be stored.
bool PerspectiveCamera::GenerateRays(std::span<const Vec2> image_points, Ray* rays) const {
  const Vec3 center = center_, forward = forward_, right = right_, up = up_;
  for (const Vec2 image_point : image_points) {
    Ray& ray = *rays++;
    ray.origin = center;
    ray.t_min = 0;
    ray.direction = Normalize(forward + right * image_point.x + up * image_point.y);
    ray.t_max = Ray().t_max;
    ray.time = 0;
    ray.mask = kCameraRay;
  }
  return true;
}

// The ray of the middle, along d, is in focus at d F / (d.n) from the centre, with the distance of
// focus F and the normal n of the plane. Where a tilted plane lies behind, d.n is negative: what
// the lens gathers from there would meet behind it, so it sees a beam that spreads from there. In
// between, d.n = 0, it sees the same direction from everywhere.
Ray PerspectiveCamera::GenerateRay(Vec2 image_point, Vec2 u) const {
  Ray ray = GenerateRay(image_point);
  if (IsPinhole()) return ray;
  const float ahead = Dot(ray.direction, lens_.view());
  if (!(ahead > 0))
    return ray;  // A slanted `up` may lead the picture to where nothing is in focus.
  const Vec3 offset = lens_.PointAt(u);
  ray.origin = center_ + offset;
  if (lens_.IsTilted()) {
    const float over_distance = Dot(ray.direction, lens_.focus_normal()) / lens_.focus_distance();
    ray.direction = Normalize(ray.direction - offset * over_distance);
  } else {
    const Vec3 in_focus = ray.direction * (lens_.focus_distance() / ahead);
    ray.direction = Normalize(in_focus - offset);
  }
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

// `GenerateRay` makes w ~ d - o (d.n) / F of d, with the offset o; the product with n gives
// w.n ~ (d.n) (1 - o.n / F), so d ~ w + o (w.n) / (F - o.n).
Vec3d PerspectiveCamera::SeenFromCentre(Vec3d offset, Vec3d way) const {
  const auto focus = static_cast<double>(lens_.focus_distance());
  if (!lens_.IsTilted()) return offset + way * (focus / Dot(way, ToDouble(lens_.view())));
  const Vec3d n = ToDouble(lens_.focus_normal());
  return way + offset * (Dot(way, n) / (focus - Dot(offset, n)));
}

// With d = forward + right x + up y and D = |det(forward, right, up)|, a part dx dy of the image
// plane is seen from the centre under the solid angle D / |d|^3 dx dy. A point of the lens sees it
// along w = d - o (d.n) / F, which is linear in d with the determinant 1 - o.n / F, so under the
// solid angle D (1 - o.n / F) / |w|^3 dx dy. Of w only the length is lost on the way, and w.v is
// d.v for the direction of view v, at right angles to o.
std::optional<CameraConnection> PerspectiveCamera::Connect(Vec3 p, Vec2 u) const {
  Vec3d way = ToDouble(p) - ToDouble(center_);
  const Vec3d view = ToDouble(lens_.view());
  // What is not ahead of the lens is seen through its middle only; see `GenerateRay`.
  const bool has_lens = !IsPinhole() && Dot(way, view) > 0;
  Vec3d seen = way;
  double narrowing = 1;
  if (has_lens) {
    const Vec3d offset = ToDouble(lens_.PointAt(u));
    way = way - offset;
    seen = SeenFromCentre(offset, way);
    if (lens_.IsTilted()) {
      narrowing -=
          Dot(offset, ToDouble(lens_.focus_normal())) / static_cast<double>(lens_.focus_distance());
    }
  }
  const std::optional<Vec2> image_point = ImagePointOf(seen);
  const double distance = Length(way);
  if (!image_point || !(distance > 0)) return std::nullopt;

  const Vec3d d = ToDouble(forward_) + ToDouble(right_) * double{image_point->x} +
                  ToDouble(up_) * double{image_point->y};
  const double determinant =
      std::abs(Dot(ToDouble(forward_), Cross(ToDouble(right_), ToDouble(up_)))) * narrowing;
  const double stretch = has_lens ? distance * Dot(d, view) / Dot(way, view) : Length(d);
  CameraConnection connection;
  connection.direction = ToFloat(way * (-1 / distance));
  connection.distance = static_cast<float>(distance);
  connection.image_point = *image_point;
  connection.importance =
      static_cast<float>(stretch * stretch * stretch / (determinant * distance * distance));
  return connection;
}

}  // namespace candela
