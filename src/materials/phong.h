#pragma once

#include <memory>

#include "materials/material.h"
#include "scene_spec/param_reader.h"

namespace candela {

/// The course's material. Without a `diffuse` of its own it is white to lights but takes no ambient
/// light, as the course's reference has it.
class PhongMaterial final : public Material {
 public:
  explicit PhongMaterial(const PhongTerms& terms) : terms_(terms) {}
  static std::unique_ptr<Material> Create(ParamReader* params);

  PhongTerms Phong(const SurfacePoint&) const override { return terms_; }
  void Evaluate(const SurfacePoint& point, Bsdf* bsdf) const override;
  /// Light transport refuses highlights, which do not conserve energy, and what would be no albedo.
  bool IsPhysical() const override;

 private:
  PhongTerms terms_;
};

}  // namespace candela
