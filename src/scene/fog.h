#pragma once

#include "math/spectrum.h"
#include "math/vec.h"
#include "scene_spec/scene_spec.h"

namespace candela {

/// Fog in the sense of the course: along a ray it takes away a part of what is seen and puts its
/// own colour in place of that. It fills the half-spaces that `FogSpec` says.
class Fog {
 public:
  explicit Fog(const FogSpec& spec) : spec_(spec) {}

  Rgb color() const { return spec_.color; }

  /// The part of the light that comes through along `distance`, which may be infinite, from
  /// `origin` in the unit direction `direction`: e to the power of minus the optical depth.
  float Transmittance(Vec3 origin, Vec3 direction, double distance) const;

  /// The integral of the density along the same, in closed form; not negative, may be infinite.
  double OpticalDepth(Vec3 origin, Vec3 direction, double distance) const;

 private:
  double DensityAt(double y) const;
  /// The optical depth from the height `y` straight up to where the fog ends.
  double ColumnAbove(double y) const;

  FogSpec spec_;
};

}  // namespace candela
