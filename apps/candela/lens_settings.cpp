#include "candela/lens_settings.h"

namespace candela {
namespace {

constexpr ArgTraits kInFilm{.block = "Film"};
constexpr const char* kNeedsFlatFilm = "is for a camera of the type 'perspective'";

}  // namespace

void LensSettings::Add(ArgParser* parser) {
  parser->Option("bloom",
                 {Fraction("STRENGTH", &bloom_strength_), Fraction("RADIUS", &bloom_radius_)},
                 "spread that part of the light, as far as RADIUS times the height of the picture; "
                 "both from 0 to 1 (default off)",
                 kInFilm);
  parser->Option("vignette", {Fraction("STRENGTH", &vignette_)},
                 "darken the picture towards its edges, with 1 as a lens does: by the fourth power "
                 "of the cosine to the direction of view (default 0)",
                 kInFilm);
}

void LensSettings::CheckScene(const ArgParser& parser, const SceneSpec& spec,
                              Diagnostics* diagnostics) {
  has_flat_film_ = spec.camera.type.empty() || spec.camera.type == "perspective";
  const Param* vignette = spec.film.params.Find("vignette");
  if (has_flat_film_ || !vignette || parser.Has("vignette") || vignette_.value_or(0) == 0) return;
  diagnostics->Error(vignette->where, std::string("'vignette' ") + kNeedsFlatFilm);
}

Result<void> LensSettings::Check(const ArgParser& parser) const {
  if (has_flat_film_ || !parser.Has("vignette") || *vignette_ == 0) return {};
  return UsageError(std::string("--vignette ") + kNeedsFlatFilm);
}

LensEffects LensSettings::Effects() const {
  return {bloom_strength_.value_or(0), bloom_radius_.value_or(0), vignette_.value_or(0)};
}

}  // namespace candela
