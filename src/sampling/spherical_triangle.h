#pragma once

#include "math/vec.h"

namespace candela {

/// The directions in which a triangle is seen from a point, drawn with equal density: Arvo,
/// "Stratified Sampling of Spherical Triangles", 1995. In double, which stands seen sizes down to
/// about 1e-6 steradian; smaller ones are sampled by area.
class SphericalTriangle {
 public:
  /// The corners, seen from the origin; none lies in it.
  SphericalTriangle(Vec3d a, Vec3d b, Vec3d c);

  /// In steradian, from 0 to 2 pi.
  double SolidAngle() const { return solid_angle_; }

  /// A unit vector, for a solid angle above 0.
  Vec3d Sample(Vec2 u) const;
  /// Over solid angle.
  double Pdf() const { return 1 / solid_angle_; }
  /// The pair that `Sample` takes to the direction `w`.
  Vec2 Invert(Vec3d w) const;

 private:
  Vec3d a_, b_, c_;  ///< Unit vectors.
  double solid_angle_;
};

}  // namespace candela
