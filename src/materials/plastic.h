#pragma once

#include <memory>
#include <optional>

#include "materials/energy_table.h"
#include "materials/material.h"
#include "scene_spec/param_reader.h"

namespace candela {

/// A coloured diffuse ground under a clear coat: plastic, paint, glazed ceramics. On both sides.
class PlasticMaterial final : public Material {
 public:
  PlasticMaterial(Rgb albedo, float ior, float alpha);
  static std::unique_ptr<Material> Create(ParamReader* params);

  PhongTerms Phong(const SurfacePoint&) const override;
  void Evaluate(const SurfacePoint& point, Bsdf* bsdf) const override;
  bool IsPhysical() const override { return true; }

 private:
  Rgb albedo_;
  PlasticParams coat_;
  std::optional<EnergyTable> energy_;  ///< Of a rough coat.
};

}  // namespace candela
