#pragma once

#include <memory>
#include <optional>

#include "materials/material.h"
#include "materials/material_context.h"
#include "materials/roughness.h"
#include "scene_spec/param_reader.h"

namespace candela {

/// The boundary of glass, water and the like, polished or ground. The body is on the side that the
/// normal points away from.
class DielectricMaterial final : public Material {
 public:
  DielectricMaterial(float ior, Roughness roughness, Rgb absorption);
  static std::unique_ptr<Material> Create(ParamReader* params, const MaterialContext& context);

  PhongTerms Phong(const SurfacePoint& point) const override;
  void Evaluate(const SurfacePoint& point, Bsdf* bsdf) const override;
  Rgb Absorption() const override { return absorption_; }
  bool NeedsTextureCoordinates() const override { return roughness_.NeedsTextureCoordinates(); }
  bool IsPhysical() const override { return true; }

 private:
  float ior_;
  Roughness roughness_;
  Rgb absorption_;
  std::optional<EnergyTable> outside_, inside_;  ///< Of a rough one.
};

}  // namespace candela
