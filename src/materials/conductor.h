#pragma once

#include <memory>
#include <optional>

#include "materials/energy_table.h"
#include "materials/material.h"
#include "scene_spec/param_reader.h"

namespace candela {

/// Bare metal, polished, ground or brushed, on both sides.
class ConductorMaterial final : public Material {
 public:
  /// `rotation_degrees` turns the direction of `surface.alpha_x` in the surface, counter-clockwise
  /// as seen from outside. Where both roughnesses are below `kSmoothestAlpha` it is polished.
  ConductorMaterial(Rgb eta, Rgb k, Ggx surface, float rotation_degrees);
  static std::unique_ptr<Material> Create(ParamReader* params);

  PhongTerms Phong(const SurfacePoint&) const override;
  void Evaluate(const SurfacePoint& point, Bsdf* bsdf) const override;
  bool IsPhysical() const override { return true; }

 private:
  ConductorParams params_;
  std::optional<EnergyTable> energy_;  ///< Of a rough one.
};

}  // namespace candela
