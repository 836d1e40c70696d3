#include "materials/dielectric.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "materials/index_ratio.h"
#include "materials/pane.h"
#include "math/wavelength.h"

namespace candela {
namespace {

/// Where the indices of all wavelengths lie closer together, the energies of yellow light are those
/// of all: the error is below that of the tables. Else there are tables at such steps of the index,
/// but no more than so many.
constexpr float kLeastSpread = 0.01f, kRatioStep = 0.05f, kMostRatioSteps = 8;
/// No two media have a smaller one.
constexpr float kLeastRatio = 0.1f;

/// Under a film there are so many for each fringe between the ends of visible light. Where that
/// makes more than so many the film is thick, and facets of all slopes blur the fringes.
constexpr float kStepsPerFringe = 8, kMostFilmSteps = 48;

/// Where ratios of indices lie around 1 there are so many steps on either side, or under a film as
/// many as there may be.
constexpr float kStepsFrom1 = 4;

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
  const bool has_energy = !roughness_.IsNowhere() && (film_ || RatioRange(a, b).HasContrast());
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
    tables.film = film_->Table(outside, {base, base, base}, {0, 0, 0}, energies);
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
  tables->is_around_1 = range.IsAround1();
  if (!tables->is_around_1 && !(range.Spread() >= kLeastSpread)) return;
  float steps = std::clamp(std::ceil(range.Spread() / kRatioStep), 1.0f, kMostRatioSteps);
  tables->least = range.least;
  tables->step = (range.most - range.least) / steps;
  if (tables->is_around_1) {
    const float most = std::max(RootFrom1(range.most), -RootFrom1(range.least));
    steps = 2 * kStepsFrom1;
    tables->least = -most;
    tables->step = most / kStepsFrom1;
  }
  for (float i = 0; i <= steps; ++i) {
    const float value = tables->least + tables->step * i;
    // Far below what there is the root would lead to none.
    const float ratio = tables->is_around_1 ? std::max(RatioOfRoot(value), kLeastRatio) : value;
    tables->steps.push_back(
        {energies->OfDielectric(ratio, roughness_), energies->OfDielectric(1 / ratio, roughness_)});
  }
}

void DielectricMaterial::AddEnergyByWavelength(Tables* tables, EnergyStore* energies) const {
  constexpr float kLeast = 1 / kLongestWavelength, kMost = 1 / kShortestWavelength;
  const float fringes = 2 * film_->ior() * film_->ThicknessAt({}) * (kMost - kLeast);
  const float for_film = std::min(std::ceil(fringes * kStepsPerFringe), kMostFilmSteps);
  const RatioRange range(tables->a, tables->b);
  const float for_ratio = range.IsAround1()
                              ? kMostFilmSteps
                              : std::min(std::ceil(range.Spread() / kRatioStep), kMostRatioSteps);
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
  const float index_a = tables.a.IndexAt(wavelength), index_b = tables.b.IndexAt(wavelength);
  if (!tables.film) {
    const float eta = index_b / index_a;
    return {energies->OfDielectric(eta, roughness_), energies->OfDielectric(1 / eta, roughness_)};
  }
  const float eta = FilmedRatio(index_a, index_b, true);
  const FilmParams film = FilmOf(tables, tables.a, tables.b, wavelength, {});
  return {energies->OfFilmedDielectric(eta, film, roughness_),
          energies->OfFilmedDielectric(1 / eta, film, roughness_)};
}

PhongTerms DielectricMaterial::Phong(const SurfacePoint& point) const {
  return PhongTermsOfGlass(medium_.ior, roughness_.AlphaAt(point));
}

void DielectricMaterial::Evaluate(const SurfacePoint& point, Bsdf* bsdf) const {
  const Medium *here = bsdf->medium_here, *beyond = bsdf->medium_beyond;
  const bool is_outside = Dot(point.n_shading, bsdf->frame.z) > 0;
  if (!here) {
    here = is_outside ? &kAir : &medium_;
    beyond = is_outside ? &medium_ : &kAir;
  }
  const bool is_dispersive = !here->dispersion.IsNone() || !beyond->dispersion.IsNone();
  const float wavelength = is_dispersive ? bsdf->wavelength : 0;
  if (wavelength != 0) bsdf->is_dispersive = true;
  const float alpha = roughness_.AlphaAt(point);
  Lobe lobe{LobeKind::kSmoothDielectric, 1, Spectrum(1)};
  const float index_here = here->IndexAt(wavelength), index_beyond = beyond->IndexAt(wavelength);
  lobe.dielectric = {
      index_beyond / index_here, {alpha, alpha}, nullptr, nullptr, 0, {}, nullptr, nullptr, 0};
  const bool is_rough = alpha >= kSmoothestAlpha;
  if (is_rough || film_) {
    const auto [tables, is_from_a] = TablesOf(*here, *beyond, is_outside);
    if (tables && film_) {
      lobe.dielectric.film = FilmOf(*tables, *here, *beyond, wavelength, point);
      if (is_rough) lobe.dielectric.eta = FilmedRatio(index_here, index_beyond, is_from_a);
    }
    if (tables && is_rough && (film_ || HasContrast(index_here, index_beyond))) {
      lobe.kind = LobeKind::kDielectric;
      SetEnergy(*tables, is_from_a, wavelength, &lobe.dielectric);
      lobe.dielectric.table_row = roughness_.TableRow(alpha);
    }
  }
  bsdf->Add(lobe);
}

// Bodies that the scene says nothing of may have the index of one of the media, and disperse
// differently: then those of yellow light are theirs too. Between media that refract alike the
// outside is as good as `a`.
DielectricMaterial::Side DielectricMaterial::TablesOf(const Medium& here, const Medium& beyond,
                                                      bool is_outside) const {
  Side similar;
  for (const Tables& tables : tables_) {
    for (const bool is_from_a : {is_outside, !is_outside}) {
      const Medium& first = is_from_a ? tables.a : tables.b;
      const Medium& second = is_from_a ? tables.b : tables.a;
      if (first.ior != here.ior || second.ior != beyond.ior) continue;
      const Side side{&tables, is_from_a};
      if (first.RefractsAs(here) && second.RefractsAs(beyond)) return side;
      if (!similar.tables) similar = side;
    }
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
  float value = tables.is_around_1 ? RootFrom1(ratio) : ratio;
  if (tables.film) value = 1 / wavelength;
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
  return {tables.film.get(), tables.film->RowOf(thickness), wavelength, film_->ior(), outside,
          thickness};
}

}  // namespace candela
