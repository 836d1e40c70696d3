#pragma once

#include <memory>

#include "materials/material.h"
#include "materials/material_context.h"
#include "scene_spec/param_reader.h"
#include "textures/texture_input.h"

namespace candela {

/// Two materials on the same surface, finely mixed: each has its share of the area.
class MixMaterial final : public Material {
 public:
  /// The share of the second one. Both have to outlive it.
  MixMaterial(const Material& first, const Material& second, NumberInput amount)
      : first_(first), second_(second), amount_(std::move(amount)) {}
  static std::unique_ptr<Material> Create(ParamReader* params, const MaterialContext& context);

  PhongTerms Phong(const SurfacePoint& point) const override;
  void Evaluate(const SurfacePoint& point, Bsdf* bsdf) const override;
  /// Of the part that lets light in; the first, where both do, unless only the second absorbs any.
  const Medium* Body() const override {
    const Medium *first = first_.Body(), *second = second_.Body();
    if (!first || (second && first->absorption == Rgb())) return second ? second : first;
    return first;
  }
  float Transparency(const SurfacePoint& point) const override {
    const float t = amount_.At(point);
    return first_.Transparency(point) * (1 - t) + second_.Transparency(point) * t;
  }
  bool HasHoles() const override { return first_.HasHoles() || second_.HasHoles(); }
  int MostLobes() const override { return first_.MostLobes() + second_.MostLobes(); }
  bool NeedsTextureCoordinates() const override;
  bool IsPhysical() const override { return first_.IsPhysical() && second_.IsPhysical(); }

 private:
  const Material &first_, &second_;
  NumberInput amount_;
};

}  // namespace candela
