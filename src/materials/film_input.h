#pragma once

#include <memory>
#include <optional>

#include "materials/material_context.h"
#include "materials/thin_film.h"
#include "textures/texture_input.h"

namespace candela {

/// A thin clear film as parameters have it: `film_thickness`, by number or by texture, and
/// `film_ior`.
class FilmInput {
 public:
  /// Thicker ones show no colours.
  static constexpr float kThickest = 2000;
  static constexpr float kLargestIor = 3;

  /// The same thickness everywhere, in nanometres.
  FilmInput(float ior, float thickness) : ior_(ior), least_(thickness), most_(thickness) {}
  /// From `least` to `most` as `share` goes from 0 to 1.
  FilmInput(float ior, float least, float most, NumberInput share);

  /// Nothing where there is no film, or none that has a thickness.
  static std::optional<FilmInput> Create(ParamReader* params, const MaterialContext& context);

  /// For a base whose index, over that of air, is eta + i k for each colour, in a medium of the
  /// index `outside`; from `energies` if that is not null.
  std::shared_ptr<const FilmTable> Table(float outside, Rgb eta, Rgb k,
                                         EnergyStore* energies) const;

  float ThicknessAt(const SurfacePoint& point) const;
  float ior() const { return ior_; }
  bool IsTextured() const { return share_.IsTextured(); }
  bool NeedsTextureCoordinates() const { return share_.NeedsTextureCoordinates(); }

 private:
  float ior_;
  float least_, most_;
  NumberInput share_;
};

}  // namespace candela
