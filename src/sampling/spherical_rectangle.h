#pragma once

#include "math/vec.h"

namespace candela {

/// The directions in which a rectangle is seen from a point, drawn with equal density: Urena,
/// Fajardo and King, "An Area-Preserving Parametrization for Spherical Rectangles", 2013. In
/// double, which stands seen sizes down to about 1e-6 steradian; smaller ones are sampled by area.
class SphericalRectangle {
 public:
  /// One corner as seen from the origin, and the sides from there, which are orthogonal.
  SphericalRectangle(Vec3d corner, Vec3d side_x, Vec3d side_y);
  /// The same in coordinates along the sides and a normal of the rectangle: its sides go from
  /// `corner` along the first two axes.
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
  // The rectangle in coordinates along its sides: from (x0, y0, z) to (x1, y1, z), with z <= 0.
  double x0_, x1_, y0_, y1_, z_;
  double solid_angle_;
};

}  // namespace candela
