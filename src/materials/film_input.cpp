#include "materials/film_input.h"

#include <fmt/format.h>

#include <utility>

#include "materials/energy_store.h"
#include "materials/medium.h"

namespace candela {
namespace {

float Limited(ParamReader* params, std::string_view name, float value) {
  if (value <= FilmInput::kThickest) return value;
  params->Error(params->Where(name), fmt::format("a film is at most {} nm thick, found {}",
                                                 FilmInput::kThickest, value));
  return 0;
}

float ReadIor(ParamReader* params) {
  const float ior = ReadRefractiveIndex(params, "film_ior", 1.333f);
  if (ior >= 1 && ior <= FilmInput::kLargestIor) return ior;
  params->Error(params->Where("film_ior"),
                fmt::format("a film has a refractive index from 1 to {}, found {}",
                            FilmInput::kLargestIor, ior));
  return 1;
}

/// The thicknesses between which a texture goes.
Vec2 ReadRange(ParamReader* params) {
  const Vec2 range = params->Pair("film_thickness_range", {100, 400});
  if (range.x >= 0 && range.y >= range.x && range.y <= FilmInput::kThickest) return range;
  params->Error(
      params->Where("film_thickness_range"),
      fmt::format("'film_thickness_range' expects two thicknesses in ascending order from "
                  "0 to {} nm, found {} {}",
                  FilmInput::kThickest, range.x, range.y));
  return {};
}

}  // namespace

FilmInput::FilmInput(float ior, float least, float most, NumberInput share)
    : ior_(ior), least_(least), most_(most), share_(std::move(share)) {}

std::optional<FilmInput> FilmInput::Create(ParamReader* params, const MaterialContext& context) {
  if (!params->Has("film_thickness")) {
    for (const char* name : {"film_ior", "film_thickness_range"}) {
      if (!params->Has(name)) continue;
      params->Error(params->Where(name),
                    fmt::format("'{}' is for a 'film_thickness', of which there is none", name));
    }
    return std::nullopt;
  }
  const float ior = ReadIor(params);
  if (params->IsTexture("film_thickness")) {
    const NumberInput share = NumberInput::Fraction(params, "film_thickness", 0, context);
    const Vec2 range = ReadRange(params);
    if (!share.IsTextured()) return std::nullopt;
    return FilmInput(ior, range.x, range.y, share);
  }
  if (params->Has("film_thickness_range")) {
    params->Error(params->Where("film_thickness_range"),
                  "'film_thickness_range' has no effect: 'film_thickness' is no texture");
  }
  const float thickness =
      Limited(params, "film_thickness", params->NonNegative("film_thickness", 0));
  if (thickness == 0) return std::nullopt;
  return FilmInput(ior, thickness);
}

std::shared_ptr<const FilmTable> FilmInput::Table(float outside, Rgb eta, Rgb k,
                                                  EnergyStore* energies) const {
  EnergyStore own;
  // By division, which makes a base as the outside exactly 1.
  return (energies ? energies : &own)
      ->OfFilm({double{ior_} / double{outside}, double{outside}, eta / outside, k / outside, least_,
                most_});
}

float FilmInput::ThicknessAt(const SurfacePoint& point) const {
  if (!share_.IsTextured()) return least_;
  const float share = share_.At(point);
  return least_ * (1 - share) + most_ * share;
}

}  // namespace candela
