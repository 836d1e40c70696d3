#pragma once

#include <memory>
#include <span>
#include <vector>

#include "materials/material.h"
#include "materials/material_context.h"
#include "materials/medium.h"
#include "materials/roughness.h"
#include "scene_spec/param_reader.h"

namespace candela {

/// The boundary of glass, water and the like, polished or ground. The body is on the side that the
/// normal points away from.
class DielectricMaterial final : public Material {
 public:
  /// `indices` are those of other media that may lie on either side; see `MaterialContext`.
  DielectricMaterial(const Medium& medium, Roughness roughness,
                     std::span<const float> indices = {});
  static std::unique_ptr<Material> Create(ParamReader* params, const MaterialContext& context);

  PhongTerms Phong(const SurfacePoint& point) const override;
  void Evaluate(const SurfacePoint& point, Bsdf* bsdf) const override;
  const Medium* Body() const override { return &medium_; }
  bool NeedsTextureCoordinates() const override { return roughness_.NeedsTextureCoordinates(); }
  bool IsPhysical() const override { return true; }

 private:
  /// Of a rough boundary, for light that comes from the one side and from the other.
  struct Tables {
    float index_a, index_b;
    EnergyTable from_a, from_b;
  };

  void AddTables(float index_a, float index_b);

  Medium medium_;
  Roughness roughness_;
  std::vector<Tables> tables_;  ///< Of a rough one, for the media that may meet at it.
};

}  // namespace candela
