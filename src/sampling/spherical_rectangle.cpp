#include "sampling/spherical_rectangle.h"

#include <algorithm>
#include <cmath>

#include "math/elementary.h"

namespace candela {
namespace {

/// The solid angle of the rectangle from (0, 0) to (x, y) in the plane at distance z, with the sign
/// of x y.
double CornerAngle(double x, double y, double z) {
  return Atan2(x * y, z * std::sqrt(x * x + y * y + z * z));
}

double AngleOf(double x0, double x1, double y0, double y1, double z) {
  const double angle = CornerAngle(x1, y1, z) - CornerAngle(x0, y1, z) - CornerAngle(x1, y0, z) +
                       CornerAngle(x0, y0, z);
  return std::max(angle, 0.0);
}

}  // namespace

SphericalRectangle::SphericalRectangle(Vec3d corner, Vec3d side_x, Vec3d side_y) {
  const double width = Length(side_x), height = Length(side_y);
  const Vec3d x = side_x * (1 / width), y = side_y * (1 / height);
  x0_ = Dot(corner, x);
  y0_ = Dot(corner, y);
  x1_ = x0_ + width;
  y1_ = y0_ + height;
  z_ = -std::abs(Dot(corner, Cross(x, y)));
  solid_angle_ = AngleOf(x0_, x1_, y0_, y1_, -z_);
}

Vec2 SphericalRectangle::Sample(Vec2 u) const {
  // Cosines of the planes through the origin and the sides y = y0 and y = y1.
  const double b0 = -y0_ / std::sqrt(y0_ * y0_ + z_ * z_);
  const double b1 = y1_ / std::sqrt(y1_ * y1_ + z_ * z_);
  // The inner angles at the corners of x = x0; their sum less pi is what the part to the left of a
  // line x = const lacks.
  const double a0 = -x0_ / std::sqrt(x0_ * x0_ + z_ * z_);
  const double g2 = Acos(std::clamp(-a0 * b1, -1.0, 1.0));
  const double g3 = Acos(std::clamp(-a0 * b0, -1.0, 1.0));
  const double k = 2 * kPi - g2 - g3;
  // The first number is the part of the solid angle left of the line.
  const double angle = double{u.x} * solid_angle_ + k;
  const double f = (Cos(angle) * b0 - b1) / Sin(angle);
  const double c = std::clamp(std::copysign(1 / std::sqrt(f * f + b0 * b0), f), -1.0, 1.0);
  double x = -(c * z_) / std::sqrt(std::max(1 - c * c, 1e-300));
  x = std::clamp(x, x0_, x1_);
  // On the line, the height of a direction over the plane y = 0 is evenly spread.
  const double d2 = x * x + z_ * z_;
  const double h0 = y0_ / std::sqrt(d2 + y0_ * y0_), h1 = y1_ / std::sqrt(d2 + y1_ * y1_);
  const double h = h0 + double{u.y} * (h1 - h0);
  const double y = h * h < 1 ? h * std::sqrt(d2) / std::sqrt(1 - h * h) : y1_;
  return {static_cast<float>(std::clamp((x - x0_) / (x1_ - x0_), 0.0, 1.0)),
          static_cast<float>(std::clamp((y - y0_) / (y1_ - y0_), 0.0, 1.0))};
}

Vec2 SphericalRectangle::Invert(Vec2 place) const {
  const double x = x0_ + double{place.x} * (x1_ - x0_);
  const double y = y0_ + double{place.y} * (y1_ - y0_);
  const double part = AngleOf(x0_, x, y0_, y1_, -z_) / solid_angle_;
  const double d2 = x * x + z_ * z_;
  const double h0 = y0_ / std::sqrt(d2 + y0_ * y0_), h1 = y1_ / std::sqrt(d2 + y1_ * y1_);
  const double way = (y / std::sqrt(d2 + y * y) - h0) / (h1 - h0);
  return {static_cast<float>(std::clamp(part, 0.0, 1.0)),
          static_cast<float>(std::clamp(way, 0.0, 1.0))};
}

}  // namespace candela
