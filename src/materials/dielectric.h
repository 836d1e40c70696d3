#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "materials/energy_store.h"
#include "materials/film_input.h"
#include "materials/material.h"
#include "materials/material_context.h"
#include "materials/medium.h"
#include "materials/roughness.h"
#include "scene_spec/param_reader.h"

namespace candela {

/// The boundary of glass, water and the like, polished or ground. The body is on the side that the
/// normal points away from.
class DielectricMaterial final : public Material {
 public:
  /// `media` are others that may lie on either side, and `energies` has the tables of other
  /// materials; see `MaterialContext`.
  DielectricMaterial(const Medium& medium, Roughness roughness, std::span<const Medium> media = {},
                     std::optional<FilmInput> film = std::nullopt, EnergyStore* energies = nullptr);
  static std::unique_ptr<Material> Create(ParamReader* params, const MaterialContext& context);

  PhongTerms Phong(const SurfacePoint& point) const override;
  void Evaluate(const SurfacePoint& point, Bsdf* bsdf) const override;
  const Medium* Body() const override { return &medium_; }
  bool NeedsTextureCoordinates() const override {
    return roughness_.NeedsTextureCoordinates() || (film_ && film_->NeedsTextureCoordinates());
  }
  bool IsPhysical() const override { return true; }

 private:
  /// Of a rough boundary, for light that comes from the one side and from the other; under a film
  /// the middle one of three, as in `DielectricParams`.
  struct Energies {
    std::shared_ptr<const EnergyTable> from_a, from_b;
  };
  struct Tables {
    Medium a, b;
    Energies yellow;
    /// Where light of each wavelength has its own: for values that are evenly spaced, from `least`
    /// on, of the ratio of the indices, or where that lies around 1 of the root of what it is away
    /// from it; under a film of the inverse of the wavelength.
    std::vector<Energies> steps;
    float least = 0, step = 0;
    bool is_around_1 = false;
    std::shared_ptr<const FilmTable> film;
  };

  /// Where light comes from.
  struct Side {
    const Tables* tables = nullptr;
    bool is_from_a = false;
  };

  void AddTables(const Medium& a, const Medium& b, EnergyStore* energies);
  void AddEnergy(Tables* tables, EnergyStore* energies) const;
  void AddEnergyByRatio(Tables* tables, EnergyStore* energies) const;
  void AddEnergyByWavelength(Tables* tables, EnergyStore* energies) const;
  Energies EnergiesAt(const Tables& tables, float wavelength, EnergyStore* energies) const;
  Side TablesOf(const Medium& here, const Medium& beyond, bool is_outside) const;
  static void SetEnergy(const Tables& tables, bool is_from_a, float wavelength,
                        DielectricParams* glass);
  FilmParams FilmOf(const Tables& tables, const Medium& here, const Medium& beyond,
                    float wavelength, const SurfacePoint& point) const;

  Medium medium_;
  Roughness roughness_;
  std::optional<FilmInput> film_;
  /// Of a rough one and of one with a film, for the media that may meet at it.
  std::vector<Tables> tables_;
};

}  // namespace candela
