#include "materials/dielectric.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "materials/dielectric_lobe.h"
#include "materials/pane.h"
#include "math/wavelength.h"

namespace candela {
namespace {

/// Boundaries that hardly refract are taken as polished: there is no telling which facet leads from
/// one direction to the other.
constexpr float kLeastContrast = 1e-3f;

/// Where the indices of all wavelengths lie closer together, the energies of yellow light are those
/// of all: the error is below that of the tables. Else there are tables at such steps of the index,
/// but no more than so many.
constexpr float kLeastSpread = 0.01f, kRatioStep = 0.05f, kMostRatioSteps = 8;

/// Under a film there are so many for each fringe between the ends of visible light. Where that
/// makes more than so many the film is thick, and facets of all slopes blur the fringes.
constexpr float kStepsPerFringe = 8, kMostFilmSteps = 48;

/// The least and the largest ratio of the index of `b` to that of `a` for visible light.
struct RatioRange {
  RatioRange(const Medium& a, const Medium& b) : least(b.ior / a.ior), most(least) {
    if (a.dispersion.IsNone() && b.dispersion.IsNone()) return;
    constexpr int kSteps = 32;
    for (int i = 0; i <= kSteps; ++i) {
      const float part = static_cast<float>(i) / kSteps;
      const float wavelength =
          kShortestWavelength + (kLongestWavelength - kShortestWavelength) * part;
      const float ratio = b.IndexAt(wavelength) / a.IndexAt(wavelength);
      least = std::min(least, ratio);
      most = std::max(most, ratio);
    }
  }
  float Spread() const { return most / least - 1; }

  float least, most;
};

std::optional<FilmInput> ReadFilm(ParamReader* params, const MaterialContext& context,
                                  const Roughness& roughness) {
  auto film = FilmInput::Create(params, context);
  if (film && film->IsTextured() && !roughness.IsNowhere()) {
    params->Error(params->Where("film_thickness"),
                  "the film on a rough 'dielectric' has the same thickness everywhere");
    film.reset();
  }
  return film;
}

}  // namespace

std::unique_ptr<Material> DielectricMaterial::Create(ParamReader* params,
                                                     const MaterialContext& context) {
  const Medium medium = Medium::Create(params, 1.5f);
  if (params->Flag("thin", false)) {
    if (!medium.dispersion.IsNone()) {
      params->Error(params->Where("thin"), "a thin pane splits no light: it has no dispersion");
    }
    const Rgb depth = medium.absorption * params->NonNegative("thickness", 0);
    return std::make_unique<PaneMaterial>(medium.ior, depth);
  }
  Roughness roughness = Roughness::Create(params, context);
  auto film = ReadFilm(params, context, roughness);
  return std::make_unique<DielectricMaterial>(medium, std::move(roughness), context.media,
                                              std::move(film), context.energies.get());
}

DielectricMaterial::DielectricMaterial(const Medium& medium, Roughness roughness,
                                       std::span<const Medium> media, std::optional<FilmInput> film,
                                       EnergyStore* energies)
    : medium_(medium), roughness_(std::move(roughness)), film_(std::move(film)) {
  if (roughness_.IsNowhere() && !film_) return;
  EnergyStore own;
  if (!energies) energies = &own;
  AddTables(kAir, medium, energies);
  for (size_t i = 0; i < media.size(); ++i) {
    // Films lie also between bodies of the same index, as that of a bubble does.
    for (size_t j = 0; j < i + (film_ ? 1 : 0); ++j) AddTables(media[i], media[j], energies);
  }
}

void DielectricMaterial::AddTables(const Medium& a, const Medium& b, EnergyStore* energies) {
  const bool has_energy = !roughness_.IsNowhere() && std::abs(b.ior / a.ior - 1) >= kLeastContrast;
  if (!has_energy && !film_) return;
  const bool is_there = std::any_of(tables_.begin(), tables_.end(), [&](const Tables& tables) {
    return (tables.a.RefractsAs(a) && tables.b.RefractsAs(b)) ||
           (tables.a.RefractsAs(b) && tables.b.RefractsAs(a));
  });
  if (is_there) return;
  Tables& tables = tables_.emplace_back();
  tables.a = a;
  tables.b = b;
  if (film_) {
    const float outside = std::min(a.ior, b.ior), base = std::max(a.ior, b.ior);
    tables.film = film_->MakeTable(outside, {base, base, base}, {0, 0, 0});
  }
  if (has_energy) AddEnergy(&tables, energies);
}

void DielectricMaterial::AddEnergy(Tables* tables, EnergyStore* energies) const {
  tables->yellow = EnergiesAt(*tables, 0, energies);
  if (tables->a.dispersion.IsNone() && tables->b.dispersion.IsNone()) return;
  if (tables->film) {
    AddEnergyByWavelength(tables, energies);
  } else {
    AddEnergyByRatio(tables, energies);
  }
}

void DielectricMaterial::AddEnergyByRatio(Tables* tables, EnergyStore* energies) const {
  const RatioRange range(tables->a, tables->b);
  if (!(range.Spread() >= kLeastSpread)) return;
  const float steps = std::clamp(std::ceil(range.Spread() / kRatioStep), 1.0f, kMostRatioSteps);
  tables->least = range.least;
  tables->step = (range.most - range.least) / steps;
  for (float i = 0; i <= steps; ++i) {
    const float ratio = range.least + tables->step * i;
    tables->steps.push_back(
        {energies->OfDielectric(ratio, roughness_), energies->OfDielectric(1 / ratio, roughness_)});
  }
}

void DielectricMaterial::AddEnergyByWavelength(Tables* tables, EnergyStore* energies) const {
  constexpr float kLeast = 1 / kLongestWavelength, kMost = 1 / kShortestWavelength;
  const float fringes = 2 * film_->ior() * film_->ThicknessAt({}) * (kMost - kLeast);
  const float for_film = std::min(std::ceil(fringes * kStepsPerFringe), kMostFilmSteps);
  const float for_ratio =
      std::min(std::ceil(RatioRange(tables->a, tables->b).Spread() / kRatioStep), kMostRatioSteps);
  const float steps = std::max(std::max(for_film, for_ratio), 1.0f);
  tables->least = kLeast;
  tables->step = (kMost - kLeast) / steps;
  for (float i = 0; i <= steps; ++i) {
    const float wavelength = 1 / (kLeast + tables->step * i);
    tables->steps.push_back(EnergiesAt(*tables, wavelength, energies));
  }
}

DielectricMaterial::Energies DielectricMaterial::EnergiesAt(const Tables& tables, float wavelength,
                                                            EnergyStore* energies) const {
  const float eta = tables.b.IndexAt(wavelength) / tables.a.IndexAt(wavelength);
  if (!tables.film) {
    return {energies->OfDielectric(eta, roughness_), energies->OfDielectric(1 / eta, roughness_)};
  }
  const FilmParams film = FilmOf(tables, tables.a, tables.b, wavelength, {});
  return {energies->OfFilmedDielectric(eta, film, roughness_),
          energies->OfFilmedDielectric(1 / eta, film, roughness_)};
}

PhongTerms DielectricMaterial::Phong(const SurfacePoint& point) const {
  return PhongTermsOfGlass(medium_.ior, roughness_.AlphaAt(point));
}

void DielectricMaterial::Evaluate(const SurfacePoint& point, Bsdf* bsdf) const {
  const Medium *here = bsdf->medium_here, *beyond = bsdf->medium_beyond;
  if (!here) {
    const bool is_outside = Dot(point.n_shading, bsdf->frame.z) > 0;
    here = is_outside ? &kAir : &medium_;
    beyond = is_outside ? &medium_ : &kAir;
  }
  const bool is_dispersive = !here->dispersion.IsNone() || !beyond->dispersion.IsNone();
  const float wavelength = is_dispersive ? bsdf->wavelength : 0;
  if (wavelength != 0) bsdf->is_dispersive = true;
  const float alpha = roughness_.AlphaAt(point);
  Lobe lobe{LobeKind::kSmoothDielectric, 1, Spectrum(1)};
  const float eta = beyond->IndexAt(wavelength) / here->IndexAt(wavelength);
  lobe.dielectric = {eta, {alpha, alpha}, nullptr, nullptr, 0, {}, nullptr, nullptr, 0};
  const bool is_rough = alpha >= kSmoothestAlpha;
  if (is_rough || film_) {
    if (const Tables* tables = TablesOf(*here, *beyond)) {
      if (film_) lobe.dielectric.film = FilmOf(*tables, *here, *beyond, wavelength, point);
      if (is_rough && tables->yellow.from_a) {
        lobe.kind = LobeKind::kDielectric;
        SetEnergy(*tables, tables->a.ior == here->ior && tables->b.ior == beyond->ior, wavelength,
                  &lobe.dielectric);
        lobe.dielectric.table_row = roughness_.TableRow(alpha);
      }
    }
  }
  bsdf->Add(lobe);
}

// Bodies that the scene says nothing of may have the index of one of the media, and disperse
// differently: then those of yellow light are theirs too.
const DielectricMaterial::Tables* DielectricMaterial::TablesOf(const Medium& here,
                                                               const Medium& beyond) const {
  const Tables* similar = nullptr;
  for (const Tables& tables : tables_) {
    const bool is_from_a = tables.a.ior == here.ior && tables.b.ior == beyond.ior;
    if (!is_from_a && !(tables.b.ior == here.ior && tables.a.ior == beyond.ior)) continue;
    const bool is_same = is_from_a ? tables.a.RefractsAs(here) && tables.b.RefractsAs(beyond)
                                   : tables.b.RefractsAs(here) && tables.a.RefractsAs(beyond);
    if (is_same) return &tables;
    if (!similar) similar = &tables;
  }
  return similar;
}

void DielectricMaterial::SetEnergy(const Tables& tables, bool is_from_a, float wavelength,
                                   DielectricParams* glass) {
  const auto set = [is_from_a](const Energies& energies, const EnergyTable** energy_here,
                               const EnergyTable** energy_beyond) {
    *energy_here = (is_from_a ? energies.from_a : energies.from_b).get();
    *energy_beyond = (is_from_a ? energies.from_b : energies.from_a).get();
  };
  if (wavelength == 0 || tables.steps.empty()) {
    set(tables.yellow, &glass->energy_here, &glass->energy_beyond);
    return;
  }
  const float ratio = is_from_a ? glass->eta : 1 / glass->eta;
  const float value = tables.film ? 1 / wavelength : ratio;
  const float place = std::max((value - tables.least) / tables.step, 0.0f);
  const size_t first = std::min(static_cast<size_t>(place), tables.steps.size() - 2);
  set(tables.steps[first], &glass->energy_here, &glass->energy_beyond);
  set(tables.steps[first + 1], &glass->next_here, &glass->next_beyond);
  glass->next_part = std::min(place - static_cast<float>(first), 1.0f);
}

FilmParams DielectricMaterial::FilmOf(const Tables& tables, const Medium& here,
                                      const Medium& beyond, float wavelength,
                                      const SurfacePoint& point) const {
  const float thickness = film_->ThicknessAt(point);
  const float outside = std::min(here.IndexAt(wavelength), beyond.IndexAt(wavelength));
  return {&*tables.film, tables.film->RowOf(thickness), wavelength, film_->ior(), outside,
          thickness};
}

}  // namespace candela
