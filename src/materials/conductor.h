#pragma once

#include <memory>
#include <optional>

#include "materials/film_input.h"
#include "materials/material.h"
#include "materials/material_context.h"
#include "materials/roughness.h"
#include "scene_spec/param_reader.h"

namespace candela {

/// Metal, polished, ground or brushed, bare or under a thin film, on both sides.
class ConductorMaterial final : public Material {
 public:
  /// `energies` has the tables of other materials; see `MaterialContext`.
  ConductorMaterial(Rgb eta, Rgb k, Roughness roughness,
                    std::optional<FilmInput> film = std::nullopt, EnergyStore* energies = nullptr);
  /// Brushed: `rotation_degrees` turns the direction of `surface.alpha_x` in the surface,
  /// counter-clockwise as seen from outside, away from where the first texture coordinate grows.
  ConductorMaterial(Rgb eta, Rgb k, Ggx surface, float rotation_degrees,
                    std::optional<FilmInput> film = std::nullopt, EnergyStore* energies = nullptr);
  static std::unique_ptr<Material> Create(ParamReader* params, const MaterialContext& context);

  PhongTerms Phong(const SurfacePoint& point) const override;
  void Evaluate(const SurfacePoint& point, Bsdf* bsdf) const override;
  bool NeedsTextureCoordinates() const override {
    return params_.is_brushed || roughness_.NeedsTextureCoordinates() ||
           (film_ && film_->NeedsTextureCoordinates());
  }
  bool IsPhysical() const override { return true; }

 private:
  FilmParams FilmAt(const SurfacePoint& point) const;

  ConductorParams params_;             ///< Of a brushed one all of them, else those of the metal.
  Roughness roughness_;                ///< Of one that is not.
  std::optional<EnergyTable> energy_;  ///< Of a rough one.
  std::optional<FilmInput> film_;
  std::shared_ptr<const FilmTable> film_table_;
};

}  // namespace candela
