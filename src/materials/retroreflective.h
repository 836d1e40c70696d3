#pragma once

#include <memory>

#include "materials/energy_table.h"
#include "materials/material.h"
#include "materials/material_context.h"
#include "materials/roughness.h"
#include "scene_spec/param_reader.h"
#include "textures/texture_input.h"

namespace candela {

/// A diffuse ground, a part of which is covered with what sends light back to where it came from:
/// road signs, safety vests, screens of glass beads. On both sides.
class RetroreflectiveMaterial final : public Material {
 public:
  /// `amount` is the share that sends light back, of which `reflectance` is the colour.
  RetroreflectiveMaterial(ColorInput albedo, ColorInput reflectance, NumberInput amount,
                          Roughness roughness);
  static std::unique_ptr<Material> Create(ParamReader* params, const MaterialContext& context);

  PhongTerms Phong(const SurfacePoint& point) const override;
  void Evaluate(const SurfacePoint& point, Bsdf* bsdf) const override;
  int MostLobes() const override { return 2; }
  bool NeedsTextureCoordinates() const override {
    return albedo_.NeedsTextureCoordinates() || reflectance_.NeedsTextureCoordinates() ||
           amount_.NeedsTextureCoordinates() || roughness_.NeedsTextureCoordinates();
  }
  bool IsPhysical() const override { return true; }

 private:
  ColorInput albedo_, reflectance_;
  NumberInput amount_;
  Roughness roughness_;
  EnergyTable energy_;
};

}  // namespace candela
