#pragma once

#include <memory>

#include "materials/material.h"
#include "materials/material_context.h"
#include "scene_spec/param_reader.h"
#include "textures/texture_input.h"

namespace candela {

/// A diffuse surface of the given albedo on both sides: ideally diffuse without roughness, and the
/// flatter looking the rougher, as plaster and the moon are.
class DiffuseMaterial final : public Material {
 public:
  /// `roughness` is from 0 to 1.
  explicit DiffuseMaterial(ColorInput albedo, NumberInput roughness = 0)
      : albedo_(std::move(albedo)), roughness_(std::move(roughness)) {}
  static std::unique_ptr<Material> Create(ParamReader* params, const MaterialContext& context);

  PhongTerms Phong(const SurfacePoint& point) const override;
  void Evaluate(const SurfacePoint& point, Bsdf* bsdf) const override;
  bool NeedsTextureCoordinates() const override {
    return albedo_.NeedsTextureCoordinates() || roughness_.NeedsTextureCoordinates();
  }
  bool IsPhysical() const override { return true; }

 private:
  ColorInput albedo_;
  NumberInput roughness_;
};

}  // namespace candela
