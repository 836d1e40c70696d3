#pragma once

#include <memory>
#include <optional>

#include "materials/material.h"
#include "materials/material_context.h"
#include "materials/roughness.h"
#include "scene_spec/param_reader.h"
#include "textures/texture_input.h"

namespace candela {

/// A coloured diffuse ground under a clear coat: plastic, paint, glazed ceramics. On both sides.
class PlasticMaterial final : public Material {
 public:
  PlasticMaterial(ColorInput albedo, float ior, Roughness roughness);
  static std::unique_ptr<Material> Create(ParamReader* params, const MaterialContext& context);

  PhongTerms Phong(const SurfacePoint& point) const override;
  void Evaluate(const SurfacePoint& point, Bsdf* bsdf) const override;
  bool NeedsTextureCoordinates() const override {
    return albedo_.NeedsTextureCoordinates() || roughness_.NeedsTextureCoordinates();
  }
  bool IsPhysical() const override { return true; }

 private:
  ColorInput albedo_;
  float ior_;
  float mean_reflectance_;  ///< Of a polished coat, for diffuse light.
  Roughness roughness_;
  std::optional<EnergyTable> energy_;  ///< Of a rough coat.
};

}  // namespace candela
