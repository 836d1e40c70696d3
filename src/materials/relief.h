#pragma once

#include <memory>

#include "materials/material.h"
#include "materials/material_context.h"
#include "scene_spec/param_reader.h"

namespace candela {

/// Another material with a relief that is not in the geometry: it bends the normals, by a map of
/// normals or by one of heights: Blinn, "Simulation of Wrinkled Surfaces", 1978. `whitted` does not
/// see it.
class ReliefMaterial final : public Material {
 public:
  /// What the map holds: normals in the frame of the texture coordinates, each component from -1 to
  /// 1 stored as 0 to 1; or heights, to multiply by a length.
  enum class Map { kNormals, kHeights };

  ReliefMaterial(std::unique_ptr<Material> material, std::shared_ptr<const Texture> texture,
                 Map map, float height);
  /// The material itself, with the relief that the parameters `normal_map` or `bump_map` of any
  /// material give it.
  static std::unique_ptr<Material> Applied(std::unique_ptr<Material> material, ParamReader* params,
                                           const MaterialContext& context);

  PhongTerms Phong(const SurfacePoint& point) const override { return material_->Phong(point); }
  PhongOptics Optics(const SurfacePoint& point) const override { return material_->Optics(point); }
  bool HasOptics() const override { return material_->HasOptics(); }
  void Evaluate(const SurfacePoint& point, Bsdf* bsdf) const override;
  const Medium* Body() const override { return material_->Body(); }
  float Transparency(const SurfacePoint& point) const override {
    return material_->Transparency(point);
  }
  bool HasHoles() const override { return material_->HasHoles(); }
  int MostLobes() const override { return material_->MostLobes(); }
  bool BendsNormals() const override { return true; }
  bool NeedsTextureCoordinates() const override { return true; }
  bool IsPhysical() const override { return material_->IsPhysical(); }

 private:
  Vec3 NormalOfMap(const SurfacePoint& point) const;
  Vec3 NormalOfHeights(const SurfacePoint& point) const;
  /// The same by steps of texture coordinates, where nothing says how long others should be.
  Vec3 NormalOfHeightsByUv(const SurfacePoint& point) const;
  float HeightAt(const SurfacePoint& point) const;

  std::unique_ptr<Material> material_;
  std::shared_ptr<const Texture> texture_;
  Map map_;
  float height_;
};

}  // namespace candela
