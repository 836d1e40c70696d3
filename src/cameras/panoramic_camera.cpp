#include "cameras/panoramic_camera.h"

#include <fmt/format.h>

#include <cmath>

#include "cameras/moving_camera.h"
#include "math/elementary.h"

namespace candela {

PanoramicCamera::PanoramicCamera(const CameraSpec& spec)
    : spec_(spec),
      axes_(AxesOf(spec)),
      angle_per_unit_(static_cast<double>(spec.fov_degrees) * (kPi / 360)),
      half_turn_(360 / spec.fov_degrees) {}

std::unique_ptr<Camera> PanoramicCamera::Create(ParamReader* params, CameraSpec view) {
  view.fov_degrees = params->HalfAngle("fov", 180);
  return std::make_unique<PanoramicCamera>(view);
}

std::unique_ptr<Camera> PanoramicCamera::Moving(const CameraMotion& motion) const {
  return std::make_unique<MovingCamera<PanoramicCamera>>(*this, motion);
}

std::string PanoramicCamera::Description() const {
  return fmt::format("{}, panoramic, {:.6g} degrees", DescribeView(spec_), spec_.fov_degrees);
}

CameraFootprint PanoramicCamera::FootprintPerUnit() const {
  return {0, static_cast<float>(angle_per_unit_)};
}

bool PanoramicCamera::Shows(Vec2 image_point) const {
  return std::abs(image_point.x) <= 3 * half_turn_ && std::abs(image_point.y) <= half_turn_;
}

Ray PanoramicCamera::GenerateRay(Vec2 image_point) const {
  Ray ray(spec_.center, Vec3());
  ray.mask = kCameraRay;
  if (!Shows(image_point)) return ray;
  const double longitude = double{image_point.x} * angle_per_unit_;
  // Beyond a pole its cosine is negative, which is half a turn of longitude.
  const double latitude = double{image_point.y} * angle_per_unit_;
  const double level = Cos(latitude);
  ray.direction = ToFloat(Normalize(ToDouble(axes_.x) * (Sin(longitude) * level) +
                                    ToDouble(axes_.y) * Sin(latitude) +
                                    ToDouble(axes_.z) * (Cos(longitude) * level)));
  return ray;
}

// A part of the picture covers the square of its angles, times the cosine of the latitude.
std::optional<CameraConnection> PanoramicCamera::Connect(Vec3 p, Vec2) const {
  const Vec3d way = ToDouble(p) - ToDouble(spec_.center);
  const double x = Dot(way, ToDouble(axes_.x)), y = Dot(way, ToDouble(axes_.y));
  const double z = Dot(way, ToDouble(axes_.z));
  const double level = std::sqrt(x * x + z * z), distance = Length(way);
  if (!(level > 0)) return std::nullopt;  // A pole is a line of the picture, as is no point.
  CameraConnection connection;
  connection.direction = ToFloat(way * (-1 / distance));
  connection.distance = static_cast<float>(distance);
  connection.image_point = {static_cast<float>(Atan2(x, z) / angle_per_unit_),
                            static_cast<float>(Atan2(y, level) / angle_per_unit_)};
  const double solid_angle = angle_per_unit_ * angle_per_unit_ * (level / distance);
  connection.importance = static_cast<float>(1 / (solid_angle * distance * distance));
  return connection;
}

// Whole turns leave the latitude as it is; half turns are seen beyond the nearer pole.
void PanoramicCamera::AddRepeats(Vec2 image_point, std::vector<Vec2>* others) const {
  const float beyond_pole = std::copysign(half_turn_, image_point.y) - image_point.y;
  for (const int half_turns : {-3, -2, -1, 1, 2, 3}) {
    const Vec2 other{image_point.x + static_cast<float>(half_turns) * half_turn_,
                     half_turns % 2 == 0 ? image_point.y : beyond_pole};
    if (Shows(other)) others->push_back(other);
  }
}

}  // namespace candela
