#pragma once

#include <memory>
#include <optional>

#include "materials/energy_table.h"
#include "materials/material.h"
#include "scene_spec/param_reader.h"

namespace candela {

/// The boundary of glass, water and the like, polished or ground. The body is on the side that the
/// normal points away from.
class DielectricMaterial final : public Material {
 public:
  DielectricMaterial(float ior, float alpha, Rgb absorption);
  static std::unique_ptr<Material> Create(ParamReader* params);

  PhongTerms Phong(const SurfacePoint&) const override;
  void Evaluate(const SurfacePoint& point, Bsdf* bsdf) const override;
  Rgb Absorption() const override { return absorption_; }
  bool IsPhysical() const override { return true; }

 private:
  float ior_;
  float alpha_;
  Rgb absorption_;
  std::optional<EnergyTable> outside_, inside_;  ///< Of a rough one.
};

}  // namespace candela
