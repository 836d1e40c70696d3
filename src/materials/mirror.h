#pragma once

#include <memory>

#include "materials/material.h"
#include "materials/material_context.h"
#include "scene_spec/param_reader.h"
#include "textures/texture_input.h"

namespace candela {

/// An ideal mirror on both sides, which reflects the same share at every angle.
class MirrorMaterial final : public Material {
 public:
  explicit MirrorMaterial(ColorInput reflectance) : reflectance_(std::move(reflectance)) {}
  static std::unique_ptr<Material> Create(ParamReader* params, const MaterialContext& context);

  PhongTerms Phong(const SurfacePoint& point) const override;
  void Evaluate(const SurfacePoint& point, Bsdf* bsdf) const override;
  bool NeedsTextureCoordinates() const override { return reflectance_.NeedsTextureCoordinates(); }
  bool IsPhysical() const override { return true; }

 private:
  ColorInput reflectance_;
};

}  // namespace candela
