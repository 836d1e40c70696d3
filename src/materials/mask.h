#pragma once

#include <memory>

#include "materials/material.h"
#include "materials/material_context.h"
#include "scene_spec/param_reader.h"
#include "textures/texture_input.h"

namespace candela {

/// Another material with holes, or a veil of it: leaves cut out of flat pictures, curtains.
class MaskMaterial final : public Material {
 public:
  /// The share of the area that the material covers. That has to outlive it.
  MaskMaterial(const Material& material, NumberInput opacity)
      : material_(material), opacity_(std::move(opacity)) {}
  static std::unique_ptr<Material> Create(ParamReader* params, const MaterialContext& context);

  /// `whitted` sees no holes.
  PhongTerms Phong(const SurfacePoint& point) const override { return material_.Phong(point); }
  PhongOptics Optics(const SurfacePoint& point) const override { return material_.Optics(point); }
  bool HasOptics() const override { return material_.HasOptics(); }
  void Evaluate(const SurfacePoint& point, Bsdf* bsdf) const override;
  const Medium* Body() const override { return material_.Body(); }
  float Transparency(const SurfacePoint& point) const override {
    return 1 - opacity_.At(point) * (1 - material_.Transparency(point));
  }
  bool HasHoles() const override {
    return opacity_.IsTextured() || opacity_.value() < 1 || material_.HasHoles();
  }
  int MostLobes() const override { return material_.MostLobes() + 1; }
  bool NeedsTextureCoordinates() const override {
    return opacity_.NeedsTextureCoordinates() || material_.NeedsTextureCoordinates();
  }
  bool BendsNormals() const override { return material_.BendsNormals(); }
  bool IsPhysical() const override { return material_.IsPhysical(); }

 private:
  const Material& material_;
  NumberInput opacity_;
};

}  // namespace candela
