#pragma once

#include <memory>
#include <optional>

#include "materials/material.h"
#include "materials/material_context.h"
#include "materials/roughness.h"
#include "scene_spec/param_reader.h"

namespace candela {

/// Bare metal, polished, ground or brushed, on both sides.
class ConductorMaterial final : public Material {
 public:
  ConductorMaterial(Rgb eta, Rgb k, Roughness roughness);
  /// Brushed: `rotation_degrees` turns the direction of `surface.alpha_x` in the surface,
  /// counter-clockwise as seen from outside, away from where the first texture coordinate grows.
  ConductorMaterial(Rgb eta, Rgb k, Ggx surface, float rotation_degrees);
  static std::unique_ptr<Material> Create(ParamReader* params, const MaterialContext& context);

  PhongTerms Phong(const SurfacePoint& point) const override;
  void Evaluate(const SurfacePoint& point, Bsdf* bsdf) const override;
  bool NeedsTextureCoordinates() const override {
    return params_.is_brushed || roughness_.NeedsTextureCoordinates();
  }
  bool IsPhysical() const override { return true; }

 private:
  ConductorParams params_;             ///< Of a brushed one all of them, else those of the metal.
  Roughness roughness_;                ///< Of one that is not.
  std::optional<EnergyTable> energy_;  ///< Of a rough one.
};

}  // namespace candela
