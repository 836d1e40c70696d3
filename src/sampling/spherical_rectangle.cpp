#include "sampling/spherical_rectangle.h"

#include <algorithm>
#include <cmath>

#include "math/elementary.h"

namespace candela {
namespace {

// Stands for 0 where that would be divided by.
constexpr double kTiny = 1e-300;

}  // namespace

SphericalRectangle::SphericalRectangle(Vec3d corner, double width, double height)
    : x0_(corner.x),
      x1_(corner.x + width),
      y0_(corner.y),
      y1_(corner.y + height),
      z_(std::abs(corner.z)),
      first_side_(SideTurn(x0_)),
      solid_angle_(AngleUpTo(x1_)) {}

/// Of the solid angle of the rectangle from (0, 0) to (x, y), which is atan(x y / (z r)) with the
/// sign of x y.
SphericalRectangle::Turn SphericalRectangle::CornerTurn(double x, double y) const {
  return {z_ * std::sqrt(x * x + y * y + z_ * z_), x * y};
}

/// Of the rectangle from (0, y0) to (x, y1).
SphericalRectangle::Turn SphericalRectangle::SideTurn(double x) const {
  return CornerTurn(x, y1_) * CornerTurn(x, y0_).Back();
}

/// The solid angle of the part from x0 to x.
double SphericalRectangle::AngleUpTo(double x) const {
  const Turn sum = SideTurn(x) * first_side_.Back();
  if (!(std::abs(sum.re) + std::abs(sum.im) > 0)) return 0;  // Nor is there a way to NaN.
  const double angle = FastAtan2(sum.im, sum.re);
  if (angle >= 0) return angle;
  // Over the rectangle itself it is above half a turn; seen from elsewhere just below 0 is 0, by
  // rounding.
  const bool is_over_it = x0_ < 0 && x > 0 && y0_ < 0 && y1_ > 0;
  return is_over_it ? angle + 2 * kPi : 0;
}

// The cosines of the paper are fractions with square roots below the line. Here all is multiplied
// by these, which leaves the square roots that the solid angle has needed already.
Vec2 SphericalRectangle::Sample(Vec2 u) const {
  // The first number is the part of the solid angle left of a line x = const.
  const SineAndCosine part = SinCos(static_cast<float>(double{u.x} * solid_angle_));
  const Turn angle = Turn{part.cos, part.sin} * first_side_;
  const double z2 = z_ * z_, a2 = x0_ * x0_ + z2, b2 = y0_ * y0_ + z2;
  const double f = angle.re * y0_ - a2 * b2 * y1_, sine = z_ * angle.im;
  const double size = std::abs(sine) * std::sqrt(b2 / std::max(f * f - sine * sine, kTiny));
  const double x = std::clamp((f < 0) == (angle.im > 0) ? size : -size, x0_, x1_);
  // On the line, the height y / |(x, y, z)| of a direction over the plane y = 0 is evenly spread.
  const double d2 = x * x + z2, r2_0 = d2 + y0_ * y0_, r2_1 = d2 + y1_ * y1_;
  const double h0 = y0_ * std::sqrt(r2_1), h1 = y1_ * std::sqrt(r2_0);
  const double h = h0 + double{u.y} * (h1 - h0);
  const double y = h * std::sqrt(d2 / std::max(r2_0 * r2_1 - h * h, kTiny));
  return {static_cast<float>(std::clamp((x - x0_) / (x1_ - x0_), 0.0, 1.0)),
          static_cast<float>(std::clamp((y - y0_) / (y1_ - y0_), 0.0, 1.0))};
}

Vec2 SphericalRectangle::Invert(Vec2 place) const {
  const double x = x0_ + double{place.x} * (x1_ - x0_);
  const double y = y0_ + double{place.y} * (y1_ - y0_);
  const double part = AngleUpTo(x) / solid_angle_;
  const double d2 = x * x + z_ * z_;
  const double h0 = y0_ / std::sqrt(d2 + y0_ * y0_), h1 = y1_ / std::sqrt(d2 + y1_ * y1_);
  const double way = (y / std::sqrt(d2 + y * y) - h0) / (h1 - h0);
  return {static_cast<float>(std::clamp(part, 0.0, 1.0)),
          static_cast<float>(std::clamp(way, 0.0, 1.0))};
}

SeenRectangle::SeenRectangle(Vec3d corner, Vec3d side_x, Vec3d side_y) : corner_(corner) {
  const double width = Length(side_x), height = Length(side_y);
  const double unit = std::max(width, height);
  const Vec3d x = Normalize(side_x), y = Normalize(side_y);
  is_right_angled_ = std::abs(Dot(x, y)) <= 1e-6;
  along_x_ = x / unit;
  along_y_ = y / unit;
  along_n_ = Cross(x, y) / unit;
  width_ = width / unit;
  height_ = height / unit;
}

}  // namespace candela
