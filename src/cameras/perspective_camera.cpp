#include "cameras/perspective_camera.h"

#include "math/elementary.h"

namespace candela {

PerspectiveCamera::PerspectiveCamera(const CameraSpec& spec)
    : center_(spec.center), up_(Normalize(spec.up)) {
  const Vec3 direction = Normalize(spec.direction);
  right_ = Normalize(Cross(direction, up_));
  forward_ = direction / static_cast<float>(TanDegrees(spec.fov_degrees / 2.0));
}

Ray PerspectiveCamera::GenerateRay(Vec2 image_point) const {
  return {center_, Normalize(forward_ + right_ * image_point.x + up_ * image_point.y)};
}

}  // namespace candela
