#include "materials/dielectric.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "materials/dielectric_lobe.h"
#include "materials/pane.h"

namespace candela {
namespace {

/// Boundaries that hardly refract are taken as polished: there is no telling which facet leads from
/// one direction to the other.
constexpr float kLeastContrast = 1e-3f;

/// The middle one of three, for red, green and blue.
std::shared_ptr<const EnergyTable> EnergyOf(float eta, const Roughness& roughness,
                                            const FilmTable& film) {
  DielectricParams glass{};
  glass.eta = eta;
  glass.film.table = &film;
  const auto tables = std::make_shared<std::vector<EnergyTable>>();
  for (int c = 0; c < 3; ++c) {
    tables->push_back(roughness.MakeTable(
        [&](const Ggx& surface, Vec3 wo, Vec3 m) { return FilmFacet(glass, c, surface, wo, m); },
        EnergyTable::Detail::kEdge));
  }
  return {tables, &(*tables)[1]};
}

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
  return std::make_unique<DielectricMaterial>(medium, std::move(roughness), context.indices,
                                              std::move(film), context.energies.get());
}

DielectricMaterial::DielectricMaterial(const Medium& medium, Roughness roughness,
                                       std::span<const float> indices,
                                       std::optional<FilmInput> film, EnergyStore* energies)
    : medium_(medium), roughness_(std::move(roughness)), film_(std::move(film)) {
  if (roughness_.IsNowhere() && !film_) return;
  EnergyStore own;
  if (!energies) energies = &own;
  AddTables(1, medium.ior, energies);
  for (size_t i = 0; i < indices.size(); ++i) {
    // Films lie also between bodies of the same index, as that of a bubble does.
    for (size_t j = 0; j < i + (film_ ? 1 : 0); ++j) AddTables(indices[i], indices[j], energies);
  }
}

void DielectricMaterial::AddTables(float index_a, float index_b, EnergyStore* energies) {
  const bool has_energy =
      !roughness_.IsNowhere() && std::abs(index_b / index_a - 1) >= kLeastContrast;
  if (!has_energy && !film_) return;
  const bool is_there = std::any_of(tables_.begin(), tables_.end(), [&](const Tables& tables) {
    return std::minmax(tables.index_a, tables.index_b) == std::minmax(index_a, index_b);
  });
  if (is_there) return;
  Tables& tables = tables_.emplace_back(Tables{index_a, index_b, {}, {}, {}});
  if (film_) {
    const float outside = std::min(index_a, index_b), base = std::max(index_a, index_b);
    tables.film = film_->MakeTable(outside, {base, base, base}, {0, 0, 0});
  }
  if (has_energy) AddEnergy(&tables, energies);
}

void DielectricMaterial::AddEnergy(Tables* tables, EnergyStore* energies) const {
  const float eta = tables->index_b / tables->index_a;
  if (tables->film) {
    tables->from_a = EnergyOf(eta, roughness_, *tables->film);
    tables->from_b = EnergyOf(1 / eta, roughness_, *tables->film);
  } else {
    tables->from_a = energies->OfDielectric(eta, roughness_);
    tables->from_b = energies->OfDielectric(1 / eta, roughness_);
  }
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
  lobe.dielectric = {eta, {alpha, alpha}, nullptr, nullptr, 0, {}};
  const bool is_rough = alpha >= kSmoothestAlpha;
  if (is_rough || film_) {
    for (const Tables& tables : tables_) {
      const bool is_from_a = tables.index_a == here->ior && tables.index_b == beyond->ior;
      if (!is_from_a && !(tables.index_b == here->ior && tables.index_a == beyond->ior)) continue;
      if (film_) lobe.dielectric.film = FilmOf(tables, *here, *beyond, wavelength, point);
      if (is_rough && tables.from_a) {
        lobe.kind = LobeKind::kDielectric;
        lobe.dielectric.energy_here = (is_from_a ? tables.from_a : tables.from_b).get();
        lobe.dielectric.energy_beyond = (is_from_a ? tables.from_b : tables.from_a).get();
        lobe.dielectric.table_row = roughness_.TableRow(alpha);
      }
      break;
    }
  }
  bsdf->Add(lobe);
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
