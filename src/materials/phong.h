#pragma once

#include <memory>

#include "materials/material.h"
#include "materials/material_context.h"
#include "scene_spec/param_reader.h"
#include "textures/texture_input.h"

namespace candela {

/// The course's material. Without a `diffuse` of its own it is white to lights but takes no ambient
/// light, as the course's reference has it. In its normalised form light transport knows the
/// highlight too.
class PhongMaterial final : public Material {
 public:
  explicit PhongMaterial(const PhongTerms& terms, bool is_normalised = false);
  static std::unique_ptr<Material> Create(ParamReader* params, const MaterialContext& context);

  PhongTerms Phong(const SurfacePoint& point) const override;
  PhongOptics Optics(const SurfacePoint& point) const override;
  bool HasOptics() const override { return is_transparent_ || is_glossy_; }
  void Evaluate(const SurfacePoint& point, Bsdf* bsdf) const override;
  bool NeedsTextureCoordinates() const override {
    return diffuse_.NeedsTextureCoordinates() || specular_.NeedsTextureCoordinates() ||
           transmittance_.NeedsTextureCoordinates() ||
           reflection_roughness_.NeedsTextureCoordinates();
  }
  int MostLobes() const override { return 2; }
  /// Light transport refuses highlights that are not normalised, since they do not conserve energy,
  /// what would be no albedo, and `Optics`.
  bool IsPhysical() const override;

 private:
  PhongMaterial() = default;
  void ReadOptics(ParamReader* params, const MaterialContext& context);

  ColorInput diffuse_, specular_;
  bool has_ambient_ = false;  ///< Ambient light meets the diffuse colour, not black.
  float shininess_ = 0;
  bool is_normalised_ = false;
  // What only distribution ray tracing sees.
  bool is_transparent_ = false, is_glossy_ = false;
  NumberInput reflection_roughness_;
  ColorInput transmittance_;
  float ior_ = 1;
  Rgb absorption_;
};

}  // namespace candela
