#pragma once

#include <memory>

#include "materials/material.h"
#include "scene_spec/param_reader.h"

namespace candela {

/// The course's material. Without a `diffuse` of its own it is white to lights but takes no ambient
/// light, as the course's reference has it. In its normalised form light transport knows the
/// highlight too.
class PhongMaterial final : public Material {
 public:
  explicit PhongMaterial(const PhongTerms& terms, bool is_normalised = false)
      : terms_(terms), is_normalised_(is_normalised) {}
  static std::unique_ptr<Material> Create(ParamReader* params);

  PhongTerms Phong(const SurfacePoint&) const override { return terms_; }
  void Evaluate(const SurfacePoint& point, Bsdf* bsdf) const override;
  /// Light transport refuses highlights that are not normalised, since they do not conserve energy,
  /// and what would be no albedo.
  bool IsPhysical() const override;

 private:
  PhongTerms terms_;
  bool is_normalised_;
};

}  // namespace candela
