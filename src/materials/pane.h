#pragma once

#include "materials/material.h"

namespace candela {

/// A thin sheet of glass as one surface: light goes straight through it, and all reflections
/// between its faces count.
class PaneMaterial final : public Material {
 public:
  /// `depth` is the absorption per unit of length times the thickness.
  PaneMaterial(float ior, Rgb depth) : pane_{ior, depth} {}

  PhongTerms Phong(const SurfacePoint&) const override;
  void Evaluate(const SurfacePoint& point, Bsdf* bsdf) const override;
  bool IsPhysical() const override { return true; }

 private:
  PaneParams pane_;
};

/// Glass for `whitted`, which follows no light through it: a faint reflection on a dark ground.
PhongTerms PhongTermsOfGlass(float ior, float alpha);

}  // namespace candela
