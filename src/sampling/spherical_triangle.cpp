#include "sampling/spherical_triangle.h"

#include <algorithm>
#include <cmath>

#include "math/elementary.h"

namespace candela {
namespace {

/// Van Oosterom and Strackee, "The Solid Angle of a Plane Triangle", 1983; for unit vectors.
double SolidAngleOf(Vec3d a, Vec3d b, Vec3d c) {
  const double volume = std::abs(Dot(a, Cross(b, c)));
  const double rest = 1 + Dot(a, b) + Dot(b, c) + Dot(c, a);
  return 2 * double{Atan2(static_cast<float>(volume), static_cast<float>(rest))};
}

/// The unit vector orthogonal to the unit vector `axis` in its plane with `w`.
Vec3d Orthogonal(Vec3d w, Vec3d axis) {
  return Normalize(w - axis * Dot(w, axis));
}

double Root(double x) {
  return std::sqrt(std::max(x, 0.0));
}

}  // namespace

SphericalTriangle::SphericalTriangle(Vec3d a, Vec3d b, Vec3d c)
    : a_(Normalize(a)),
      b_(Normalize(b)),
      c_(Normalize(c)),
      solid_angle_(SolidAngleOf(a_, b_, c_)) {}

Vec3d SphericalTriangle::Sample(Vec2 u) const {
  // The first number cuts off a triangle a, b, c' of a part of the area, c' on the arc from a to c.
  const Vec3d n_ab = Normalize(Cross(a_, b_)), n_ca = Normalize(Cross(c_, a_));
  const double cos_alpha = std::clamp(-Dot(n_ab, n_ca), -1.0, 1.0);
  const double sin_alpha = Root(1 - cos_alpha * cos_alpha);
  const auto [sin_part, cos_part] = SinCos(static_cast<float>(double{u.x} * solid_angle_));
  // phi is pi + part - alpha.
  const double sin_phi = cos_part * sin_alpha - sin_part * cos_alpha;
  const double cos_phi = -cos_part * cos_alpha - sin_part * sin_alpha;
  const double k1 = cos_phi + cos_alpha;
  const double k2 = sin_phi - sin_alpha * Dot(a_, b_);
  const double below = (k2 * sin_phi + k1 * cos_phi) * sin_alpha;
  double cos_b = 1;
  if (below != 0) {
    cos_b = std::clamp((k2 + (k2 * cos_phi - k1 * sin_phi) * cos_alpha) / below, -1.0, 1.0);
  }
  const Vec3d on_arc = a_ * cos_b + Orthogonal(c_, a_) * Root(1 - cos_b * cos_b);
  // The second one goes from b to c', such that area grows evenly.
  const double cos_theta = 1 - double{u.y} * (1 - Dot(on_arc, b_));
  return b_ * cos_theta + Orthogonal(on_arc, b_) * Root(1 - cos_theta * cos_theta);
}

Vec2 SphericalTriangle::Invert(Vec3d w) const {
  // c' is where the great circle through b and w crosses the arc from a to c.
  Vec3d on_arc = Cross(Cross(b_, w), Cross(c_, a_));
  const double length = Length(on_arc);
  if (!(length > 0)) return {0, 0};  // w is b itself: any first number leads there.
  on_arc = on_arc * (1 / length);
  if (Dot(on_arc, a_ + c_) < 0) on_arc = -on_arc;
  const double part = SolidAngleOf(a_, b_, on_arc) / solid_angle_;
  // Lengths of chords: 1 - cosine, without cancellation.
  const double way = LengthSquared(w - b_) / LengthSquared(on_arc - b_);
  return {static_cast<float>(std::clamp(part, 0.0, 1.0)),
          static_cast<float>(std::clamp(way, 0.0, 1.0))};
}

}  // namespace candela
