#include "cameras/fisheye_camera.h"

#include <fmt/format.h>

#include <cmath>
#include <string_view>

#include "cameras/moving_camera.h"
#include "math/elementary.h"

namespace candela {
namespace {

constexpr std::string_view kMappings[] = {"equidistant", "equisolid"};

}  // namespace

FisheyeCamera::FisheyeCamera(const CameraSpec& spec, FisheyeMapping mapping)
    : spec_(spec),
      mapping_(mapping),
      axes_(AxesOf(spec)),
      half_angle_(static_cast<double>(spec.fov_degrees) * (kPi / 360)),
      sine_of_half_(SinDegrees(spec.fov_degrees / 4.0)) {}

std::unique_ptr<Camera> FisheyeCamera::Create(ParamReader* params, CameraSpec view) {
  const size_t mapping = params->Choice("mapping", kMappings, 0);
  view.fov_degrees = params->FullAngle("fov", 180);
  return std::make_unique<FisheyeCamera>(view, static_cast<FisheyeMapping>(mapping));
}

std::unique_ptr<Camera> FisheyeCamera::Moving(const CameraMotion& motion) const {
  return std::make_unique<MovingCamera<FisheyeCamera>>(*this, motion);
}

std::string FisheyeCamera::Description() const {
  return fmt::format("{}, fisheye, {}, {:.6g} degrees", DescribeView(spec_),
                     kMappings[static_cast<size_t>(mapping_)], spec_.fov_degrees);
}

CameraFootprint FisheyeCamera::FootprintPerUnit() const {
  const bool is_equidistant = mapping_ == FisheyeMapping::kEquidistant;
  return {0, static_cast<float>(is_equidistant ? half_angle_ : 2 * sine_of_half_)};
}

// At the radius r of the circle the angle to the direction of view is r times the half angle, or
// twice the angle whose sine is r k.
Ray FisheyeCamera::GenerateRay(Vec2 image_point) const {
  Ray ray(spec_.center, Vec3());
  ray.mask = kCameraRay;
  const double x{image_point.x}, y{image_point.y};
  const double radius = std::sqrt(x * x + y * y);
  if (!(radius <= 1)) return ray;
  double sine_over_radius, cosine;
  if (mapping_ == FisheyeMapping::kEquidistant) {
    const double angle = radius * half_angle_;
    sine_over_radius = radius > 0 ? Sin(angle) / radius : half_angle_;
    cosine = Cos(angle);
  } else {
    const double sine = radius * sine_of_half_;  // Of half of the angle.
    sine_over_radius = 2 * sine_of_half_ * std::sqrt(1 - sine * sine);
    cosine = 1 - 2 * sine * sine;
  }
  const Vec3d aside = ToDouble(axes_.x) * x + ToDouble(axes_.y) * y;
  ray.direction = ToFloat(Normalize(aside * sine_over_radius + ToDouble(axes_.z) * cosine));
  return ray;
}

// With the angle t at the radius r a part r dr of the picture covers sin t dt of solid angle: with
// t = h r it is h^2 sin(t) / t per area, with sin(t / 2) = k r it is 4 k^2 everywhere.
std::optional<CameraConnection> FisheyeCamera::Connect(Vec3 p, Vec2) const {
  const Vec3d way = ToDouble(p) - ToDouble(spec_.center);
  const double x = Dot(way, ToDouble(axes_.x)), y = Dot(way, ToDouble(axes_.y));
  const double z = Dot(way, ToDouble(axes_.z));
  const double aside = std::sqrt(x * x + y * y), distance = Length(way);
  if (!(distance > 0)) return std::nullopt;
  const double angle = Atan2(aside, z);
  double radius, solid_angle;
  if (mapping_ == FisheyeMapping::kEquidistant) {
    radius = angle / half_angle_;
    solid_angle = half_angle_ * half_angle_ * (angle > 0 ? Sin(angle) / angle : 1);
  } else {
    radius = Sin(angle / 2) / sine_of_half_;
    solid_angle = 4 * sine_of_half_ * sine_of_half_;
  }
  // What is right behind it the rim shows all around, no point of it more than another.
  const bool is_behind = aside == 0 && z < 0;
  if (!(radius <= 1) || is_behind || !(solid_angle > 0)) return std::nullopt;

  CameraConnection connection;
  const double scale = aside > 0 ? radius / aside : 0;
  connection.direction = ToFloat(way * (-1 / distance));
  connection.distance = static_cast<float>(distance);
  connection.image_point = {static_cast<float>(x * scale), static_cast<float>(y * scale)};
  connection.importance = static_cast<float>(1 / (solid_angle * distance * distance));
  return connection;
}

}  // namespace candela
