#include "sampling/spherical_rectangle.h"

#include <algorithm>
#include <cmath>

#include "math/elementary.h"

namespace candela {
namespace {

/// A complex number: its argument stands for an angle, so that sums of angles are products.
struct Turn {
  double re, im;

  friend Turn operator*(Turn a, Turn b) {
    return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
  }
  Turn Back() const { return {re, -im}; }
};

/// Of the solid angle of the rectangle from (0, 0) to (x, y) in the plane at distance z, which is
/// atan(x y / (z r)) with the sign of x y.
Turn CornerTurn(double x, double y, double z) {
  const double r = std::sqrt(x * x + y * y + z * z);
  return {z * r, x * y};
}

double AngleOf(double x0, double x1, double y0, double y1, double z) {
  const Turn sum = (CornerTurn(x1, y1, z) * CornerTurn(x0, y0, z)) *
                   (CornerTurn(x0, y1, z) * CornerTurn(x1, y0, z)).Back();
  // Both are brought into the range of floats, in which the angle is asked for.
  const double largest = std::max(std::abs(sum.re), std::abs(sum.im));
  if (!(largest > 0)) return 0;
  const float angle =
      Atan2(static_cast<float>(sum.im / largest), static_cast<float>(sum.re / largest));
  if (angle >= 0) return angle;
  // Over the rectangle itself it is above half a turn; seen from elsewhere just below 0 is 0, by
  // rounding.
  const bool is_over_it = x0 < 0 && x1 > 0 && y0 < 0 && y1 > 0;
  return is_over_it ? angle + 2 * kPi : 0;
}

Vec3d AlongSides(Vec3d corner, Vec3d x, Vec3d y) {
  return {Dot(corner, x), Dot(corner, y), Dot(corner, Cross(x, y))};
}

}  // namespace

SphericalRectangle::SphericalRectangle(Vec3d corner, Vec3d side_x, Vec3d side_y)
    : SphericalRectangle(AlongSides(corner, Normalize(side_x), Normalize(side_y)), Length(side_x),
                         Length(side_y)) {}

SphericalRectangle::SphericalRectangle(Vec3d corner, double width, double height)
    : x0_(corner.x),
      x1_(corner.x + width),
      y0_(corner.y),
      y1_(corner.y + height),
      z_(-std::abs(corner.z)),
      solid_angle_(AngleOf(x0_, x1_, y0_, y1_, -z_)) {}

Vec2 SphericalRectangle::Sample(Vec2 u) const {
  // Cosines of the planes through the origin and the sides y = y0 and y = y1.
  const double z2 = z_ * z_, inverse0 = 1 / std::sqrt(y0_ * y0_ + z2);
  const double b0 = -y0_ * inverse0;
  const double b1 = y1_ / std::sqrt(y1_ * y1_ + z2);
  // The inner angles at the corners of x = x0; their sum less pi is what the part to the left of a
  // line x = const lacks.
  const double a0 = -x0_ / std::sqrt(x0_ * x0_ + z2);
  const auto turn_of_cosine = [](double cosine) {
    return Turn{cosine, std::sqrt(std::max(0.0, 1 - cosine * cosine))};
  };
  const Turn less = turn_of_cosine(-a0 * b1) * turn_of_cosine(-a0 * b0);
  // The first number is the part of the solid angle left of the line.
  const SineAndCosine part = SinCos(static_cast<float>(double{u.x} * solid_angle_));
  const Turn angle = Turn{part.cos, part.sin} * less.Back();
  // With f = (angle.re b0 - b1) / angle.im the line is at -+z / sqrt(f^2 + b0^2 - 1); both sides of
  // the fraction are left with angle.im, which spares a division.
  const double f = angle.re * b0 - b1, sine_0 = z_ * inverse0 * angle.im;
  const double squared = std::max(f * f - sine_0 * sine_0, 1e-300);
  const double size = std::abs(z_ * angle.im) / std::sqrt(squared);
  const double x = std::clamp((f < 0) == (angle.im < 0) ? size : -size, x0_, x1_);
  // On the line, the height of a direction over the plane y = 0 is evenly spread.
  const double d2 = x * x + z2;
  const double h0 = y0_ / std::sqrt(d2 + y0_ * y0_), h1 = y1_ / std::sqrt(d2 + y1_ * y1_);
  const double h = h0 + double{u.y} * (h1 - h0);
  const double y = h * h < 1 ? h * std::sqrt(d2 / (1 - h * h)) : y1_;
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
