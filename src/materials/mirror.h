#pragma once

#include <memory>

#include "materials/material.h"
#include "scene_spec/param_reader.h"

namespace candela {

/// An ideal mirror on both sides, which reflects the same share at every angle.
class MirrorMaterial final : public Material {
 public:
  explicit MirrorMaterial(Rgb reflectance) : reflectance_(reflectance) {}
  static std::unique_ptr<Material> Create(ParamReader* params);

  PhongTerms Phong(const SurfacePoint&) const override;
  void Evaluate(const SurfacePoint& point, Bsdf* bsdf) const override;
  bool IsPhysical() const override { return true; }

 private:
  Rgb reflectance_;
};

}  // namespace candela
