#pragma once

#include <memory>

#include "materials/material.h"
#include "scene_spec/param_reader.h"

namespace candela {

/// A diffuse surface of the given albedo on both sides: ideally diffuse without roughness, and the
/// flatter looking the rougher, as plaster and the moon are.
class DiffuseMaterial final : public Material {
 public:
  /// `roughness` is from 0 to 1.
  explicit DiffuseMaterial(Rgb albedo, float roughness = 0)
      : albedo_(albedo), roughness_(roughness) {}
  static std::unique_ptr<Material> Create(ParamReader* params);

  PhongTerms Phong(const SurfacePoint&) const override { return {albedo_, albedo_, {}, 0}; }
  void Evaluate(const SurfacePoint& point, Bsdf* bsdf) const override;
  bool IsPhysical() const override { return true; }

 private:
  Rgb albedo_;
  float roughness_;
};

}  // namespace candela
