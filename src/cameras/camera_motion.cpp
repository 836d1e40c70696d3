#include "cameras/camera_motion.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace candela {
namespace {

/// The times in [0, 1] at which a polynomial c + b t + a t^2 that is not 0 may be.
std::vector<double> RootsOf(double a, double b, double c) {
  // A double root, as of directions that touch, may have been rounded away. Of the two ways to
  // write a root each takes the one in which nothing cancels.
  const double root = std::sqrt(std::max(0.0, b * b - 4 * a * c));
  const double q = -(b + std::copysign(root, b)) / 2;
  std::vector<double> roots;
  if (a != 0) roots.push_back(q / a);
  if (q != 0) roots.push_back(c / q);
  return roots;
}

/// Whether `up` says which way is up all the time. The product of direction and up, of which both
/// are linear in time, is quadratic; where it is 0, its largest component is.
bool HasUpAllTheTime(const CameraSpec& begin, const CameraMotion& motion) {
  const Vec3d direction = ToDouble(begin.direction), up = ToDouble(begin.up);
  const Vec3d turn = ToDouble(motion.direction) - direction, roll = ToDouble(motion.up) - up;
  const Vec3d a = Cross(turn, roll), b = Cross(direction, roll) + Cross(turn, up);
  const Vec3d c = Cross(direction, up);
  const auto size = [&](double Vec3d::*axis) {
    return std::abs(a.*axis) + std::abs(b.*axis) + std::abs(c.*axis);
  };
  double Vec3d::*largest = &Vec3d::x;
  for (double Vec3d::*axis : {&Vec3d::y, &Vec3d::z}) {
    if (size(axis) > size(largest)) largest = axis;
  }
  std::vector<double> times = RootsOf(a.*largest, b.*largest, c.*largest);
  times.push_back(1);
  return std::all_of(times.begin(), times.end(), [&](double time) {
    const CameraSpec view = motion.At(begin, static_cast<float>(std::clamp(time, 0.0, 1.0)));
    // Written so that NaN, of directions that vanish, is wrong.
    return HasUp(view);
  });
}

}  // namespace

CameraSpec CameraMotion::At(const CameraSpec& begin, float time) const {
  const auto between = [time](Vec3 a, Vec3 b) { return a == b ? a : a * (1 - time) + b * time; };
  CameraSpec view = begin;
  view.center = between(begin.center, center);
  view.direction = between(begin.direction, direction);
  view.up = between(begin.up, up);
  return view;
}

std::optional<CameraMotion> ReadMotion(ParamReader* params, const CameraSpec& begin) {
  CameraMotion motion{begin.center, begin.direction, begin.up};
  const bool goes = params->Has("center_end");
  const bool turns = params->Has("direction_end");
  const bool rolls = params->Has("up_end");
  if (goes) motion.center = params->RequiredVector("center_end");
  if (turns) motion.direction = params->RequiredDirection("direction_end");
  if (rolls) motion.up = params->RequiredDirection("up_end");
  if (!goes && !turns && !rolls) return std::nullopt;
  if ((turns || rolls) && HasUp(begin) && !HasUpAllTheTime(begin, motion)) {
    params->Error(params->Where(turns ? "direction_end" : "up_end"),
                  "on its way to the end the direction of the camera vanishes, or becomes parallel "
                  "to 'up'");
    return std::nullopt;
  }
  return motion;
}

}  // namespace candela
