#include "cameras/perspective_camera.h"

#include <cmath>

#include "math/elementary.h"

namespace candela {

PerspectiveCamera::PerspectiveCamera(const CameraSpec& spec) : center_(spec.center) {
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
}

}  // namespace candela
