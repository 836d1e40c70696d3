#pragma once

#include <memory>
#include <optional>

#include "materials/dielectric.h"
#include "materials/material.h"
#include "materials/material_context.h"
#include "materials/principled_layers.h"
#include "materials/roughness.h"
#include "scene_spec/param_reader.h"
#include "textures/texture_input.h"

namespace candela {

/// The material of many programs, by the names that artists know: metal, plastic, glass, all that
/// lies between, with a clear coat and fuzz. See principled_lobe.h. On both sides.
class PrincipledMaterial final : public Material {
 public:
  /// All fractions and colours from 0 to 1.
  struct Inputs {
    ColorInput base_color = Rgb{0.8f, 0.8f, 0.8f};
    NumberInput metallic = 0;
    Roughness roughness = Roughness::OfAlpha(0.25f);
    NumberInput anisotropy = 0;
    float rotation_degrees = 0;
    NumberInput specular = 1, specular_tint = 0;
    float ior = 1.5f;  ///< Above 1.
    NumberInput clearcoat = 0;
    Roughness clearcoat_roughness = Roughness::OfAlpha(0);
    NumberInput sheen = 0, sheen_tint = 0, sheen_roughness = 0.3f;
    NumberInput transmission = 0;
  };

  /// `media` are others that may lie on either side; see `MaterialContext`.
  explicit PrincipledMaterial(Inputs inputs, std::span<const Medium> media = {},
                              EnergyStore* energies = nullptr);
  static std::unique_ptr<Material> Create(ParamReader* params, const MaterialContext& context);

  PhongTerms Phong(const SurfacePoint& point) const override;
  void Evaluate(const SurfacePoint& point, Bsdf* bsdf) const override;
  const Medium* Body() const override { return glass_ ? glass_->Body() : nullptr; }
  int MostLobes() const override { return glass_ ? 2 : 1; }
  bool NeedsTextureCoordinates() const override;
  bool IsPhysical() const override { return true; }

 private:
  bool IsBrushed() const { return MayBeAbove0(inputs_.anisotropy); }
  static bool MayBeAbove0(const NumberInput& input) {
    return input.IsTextured() || input.value() > 0;
  }
  Lobe OpaqueLobe(const SurfacePoint& point, Rgb base_color, float metallic, bool is_outside) const;

  Inputs inputs_;
  PrincipledLayers layers_;
  std::optional<DielectricMaterial> glass_;
};

}  // namespace candela
