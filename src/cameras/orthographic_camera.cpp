#include "cameras/orthographic_camera.h"

#include <fmt/format.h>

#include "cameras/moving_camera.h"

namespace candela {

OrthographicCamera::OrthographicCamera(const CameraSpec& spec, float height)
    : spec_(spec), axes_(AxesOf(spec)), half_height_(height / 2), lens_(spec) {}

std::unique_ptr<Camera> OrthographicCamera::Create(ParamReader* params, CameraSpec view) {
  const float height = params->RequiredPositive("height");
  ReadLens(params, &view);
  return std::make_unique<OrthographicCamera>(view, height);
}

std::unique_ptr<Camera> OrthographicCamera::Moving(const CameraMotion& motion) const {
  return std::make_unique<MovingCamera<OrthographicCamera>>(*this, motion);
}

std::string OrthographicCamera::Description() const {
  return fmt::format("{}, orthographic, {:.6g} high", DescribeView(spec_), 2 * half_height_);
}

Ray OrthographicCamera::GenerateRay(Vec2 image_point) const {
  const Vec3 aside =
      axes_.x * (image_point.x * half_height_) + axes_.y * (image_point.y * half_height_);
  Ray ray(spec_.center + aside, axes_.z);
  ray.mask = kCameraRay;
  return ray;
}

Ray OrthographicCamera::GenerateRay(Vec2 image_point, Vec2 u) const {
  Ray ray = GenerateRay(image_point);
  if (IsPinhole()) return ray;
  const Vec3 offset = lens_.PointAt(u);
  ray.origin += offset;
  ray.direction = Normalize(axes_.z * lens_.focus_distance() - offset);
  return ray;
}

// At the distance z ahead, the ray through the offset o of the lens has come from the image point's
// place q to q + o (1 - z / F), with the distance of focus F: a shift that is the same for all
// image points, so areas across the direction of view stay what they are, whatever z is. Across the
// ray they are smaller by the cosine.
std::optional<CameraConnection> OrthographicCamera::Connect(Vec3 p, Vec2 u) const {
  const Vec3d view = ToDouble(axes_.z);
  const Vec3d from_centre = ToDouble(p) - ToDouble(spec_.center);
  const double ahead = Dot(from_centre, view);
  if (!(ahead > 0)) return std::nullopt;
  const Vec3d offset = IsPinhole() ? Vec3d() : ToDouble(lens_.PointAt(u));
  const auto focus = static_cast<double>(lens_.focus_distance());
  const Vec3d way = view * ahead - offset * (ahead / focus);
  const Vec3d place = from_centre - offset - way;
  const double distance = Length(way);

  const double scale = 1 / static_cast<double>(half_height_);
  CameraConnection connection;
  connection.direction = ToFloat(way * (-1 / distance));
  connection.distance = static_cast<float>(distance);
  connection.image_point = {static_cast<float>(Dot(place, ToDouble(axes_.x)) * scale),
                            static_cast<float>(Dot(place, ToDouble(axes_.y)) * scale)};
  connection.importance = static_cast<float>(scale * scale * distance / ahead);
  return connection;
}

}  // namespace candela
