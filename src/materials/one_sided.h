#pragma once

#include <memory>

#include "materials/material.h"
#include "scene_spec/param_reader.h"

namespace candela {

/// Another material on the side that the normal points to; the other side is black. Holes are holes
/// on both sides. `whitted` does not see the difference.
class OneSidedMaterial final : public Material {
 public:
  explicit OneSidedMaterial(std::unique_ptr<Material> material) : material_(std::move(material)) {}
  /// The material itself, unless the parameter `two_sided` of any material says otherwise.
  static std::unique_ptr<Material> Applied(std::unique_ptr<Material> material, ParamReader* params);

  PhongTerms Phong(const SurfacePoint& point) const override { return material_->Phong(point); }
  PhongOptics Optics(const SurfacePoint& point) const override { return material_->Optics(point); }
  bool HasOptics() const override { return material_->HasOptics(); }
  void Evaluate(const SurfacePoint& point, Bsdf* bsdf) const override;
  float Transparency(const SurfacePoint& point) const override {
    return material_->Transparency(point);
  }
  bool HasHoles() const override { return material_->HasHoles(); }
  int MostLobes() const override { return material_->MostLobes(); }
  bool BendsNormals() const override { return material_->BendsNormals(); }
  bool NeedsTextureCoordinates() const override { return material_->NeedsTextureCoordinates(); }
  bool IsPhysical() const override { return material_->IsPhysical(); }

 private:
  std::unique_ptr<Material> material_;
};

}  // namespace candela
