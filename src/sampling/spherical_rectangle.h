#pragma once

#include "math/vec.h"

namespace candela {

/// The directions in which a rectangle is seen from a point, drawn with equal density: Urena,
/// Fajardo and King, "An Area-Preserving Parametrization for Spherical Rectangles", 2013. In
/// double, which stands seen sizes down to about 1e-6 steradian; smaller ones are sampled by area.
class SphericalRectangle {
 public:
  /// In coordinates along the sides and a normal of the rectangle: its sides go from `corner`, as
  /// it is seen from the origin, along the first two axes. In a unit of about their size, since the
  /// tenth powers of lengths have to be finite and above 0.
  SphericalRectangle(Vec3d corner, double width, double height);

  /// In steradian, from 0 to 2 pi.
  double SolidAngle() const { return solid_angle_; }

  /// Where on the rectangle the direction leads to, as parts of the sides in [0, 1]; for a solid
  /// angle above 0.
  Vec2 Sample(Vec2 u) const;
  /// Over solid angle.
  double Pdf() const { return 1 / solid_angle_; }
  /// The pair that `Sample` takes to a place on the rectangle.
  Vec2 Invert(Vec2 place) const;

 private:
  /// A complex number: its argument stands for an angle, so that sums of angles are products.
  struct Turn {
    double re, im;

    friend Turn operator*(Turn a, Turn b) {
      return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
    }
    Turn Back() const { return {re, -im}; }
  };

  Turn CornerTurn(double x, double y) const;
  Turn SideTurn(double x) const;
  double AngleUpTo(double x) const;

  // The rectangle in coordinates along its sides: from (x0, y0, z) to (x1, y1, z), with z >= 0.
  double x0_, x1_, y0_, y1_, z_;
  Turn first_side_;  ///< Of x = x0.
  double solid_angle_;
};

/// A rectangle somewhere in space, as it is seen from many points.
class SeenRectangle {
 public:
  /// One corner, and the sides from there.
  SeenRectangle(Vec3d corner, Vec3d side_x, Vec3d side_y);

  /// Whether it is one, and not the parallelogram that a transform has made of it.
  bool IsRightAngled() const { return is_right_angled_; }
  SphericalRectangle From(Vec3d p) const {
    const Vec3d way = corner_ - p;
    return {Vec3d{Dot(way, along_x_), Dot(way, along_y_), Dot(way, along_n_)}, width_, height_};
  }

 private:
  Vec3d corner_;
  Vec3d along_x_, along_y_, along_n_;  ///< The longer side is the unit of length.
  double width_, height_;
  bool is_right_angled_;
};

}  // namespace candela
