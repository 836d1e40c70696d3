#pragma once

#include <memory>

#include "materials/material.h"
#include "scene_spec/param_reader.h"

namespace candela {

/// An ideally diffuse surface of the given albedo on both sides.
class DiffuseMaterial final : public Material {
 public:
  explicit DiffuseMaterial(Rgb albedo) : albedo_(albedo) {}
  static std::unique_ptr<Material> Create(ParamReader* params);

  PhongTerms Phong(const SurfacePoint&) const override { return {albedo_, albedo_, {}, 0}; }
  void Evaluate(const SurfacePoint& point, Bsdf* bsdf) const override;
  bool IsPhysical() const override { return true; }

 private:
  Rgb albedo_;
};

}  // namespace candela
