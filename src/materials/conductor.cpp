#include "materials/conductor.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "base/text.h"
#include "materials/conductor_lobe.h"
#include "materials/fresnel.h"
#include "materials/metals.h"
#include "math/elementary.h"

namespace candela {
namespace {

/// The metal that `metal` names, or the one of `eta` and `k`.
Metal ReadMetal(ParamReader* params) {
  Metal metal = Metals()[0];
  const std::string name = params->Word("metal");
  if (!name.empty()) {
    std::vector<std::string_view> names;
    for (const Metal& each : Metals()) {
      if (each.name == name) return each;
      names.push_back(each.name);
    }
    params->Error(params->Where("metal"),
                  fmt::format("there is no metal {}{}; known: {}", Quote(name),
                              DidYouMean(name, names), ListOf(names)));
    return metal;
  }
  metal.eta = params->NonNegativeColor("eta", metal.eta);
  metal.k = params->NonNegativeColor("k", metal.k);
  const bool has_eta = params->Has("eta"), has_k = params->Has("k");
  if (!params->Has("metal") && (!has_eta || !has_k)) {
    params->Error(params->Where(has_eta ? "eta" : "k"),
                  "'conductor' needs 'metal', or 'eta' and 'k'");
  }
  return metal;
}

/// `alpha_x` and `alpha_y` of a brushed metal; nothing when they are not given.
std::optional<Ggx> ReadBrushing(ParamReader* params) {
  const bool has_x = params->Has("alpha_x"), has_y = params->Has("alpha_y");
  if (!has_x && !has_y) return std::nullopt;
  if (params->Has("roughness")) {
    params->Error(params->Where("roughness"),
                  "roughness is given by 'roughness' or by 'alpha_x' and 'alpha_y', not by both");
  } else if (has_x != has_y) {
    params->Error(params->Where(has_x ? "alpha_x" : "alpha_y"),
                  "'alpha_x' and 'alpha_y' are given together");
  }
  return Ggx{params->Fraction("alpha_x", 0), params->Fraction("alpha_y", 0)};
}

}  // namespace

std::unique_ptr<Material> ConductorMaterial::Create(ParamReader* params,
                                                    const MaterialContext& context) {
  const Metal metal = ReadMetal(params);
  const std::optional<Ggx> brushing = ReadBrushing(params);
  if (brushing) {
    const float rotation = params->Number("rotation", 0);
    return std::make_unique<ConductorMaterial>(metal.eta, metal.k, *brushing, rotation,
                                               FilmInput::Create(params, context),
                                               context.energies.get());
  }
  Roughness roughness = Roughness::Create(params, context);
  return std::make_unique<ConductorMaterial>(metal.eta, metal.k, std::move(roughness),
                                             FilmInput::Create(params, context),
                                             context.energies.get());
}

ConductorMaterial::ConductorMaterial(Rgb eta, Rgb k, Roughness roughness,
                                     std::optional<FilmInput> film, EnergyStore* energies)
    : params_{eta, k, MeanConductorReflectance(eta, k), {0, 0}, 1, 0, nullptr, 0, false, {}},
      roughness_(std::move(roughness)),
      film_(std::move(film)) {
  if (!roughness_.IsNowhere()) energy_ = roughness_.MakeTable(MirrorFacet);
  if (film_) film_table_ = film_->Table(1, eta, k, energies);
}

ConductorMaterial::ConductorMaterial(Rgb eta, Rgb k, Ggx surface, float rotation_degrees,
                                     std::optional<FilmInput> film, EnergyStore* energies)
    : ConductorMaterial(eta, k, Roughness::OfAlpha(0), std::move(film), energies) {
  const auto degrees = static_cast<double>(rotation_degrees);
  params_.cos_rotation = static_cast<float>(CosDegrees(degrees));
  params_.sin_rotation = static_cast<float>(SinDegrees(degrees));
  params_.surface = {std::max(surface.alpha_x, kSmoothestAlpha),
                     std::max(surface.alpha_y, kSmoothestAlpha)};
  energy_ = EnergyTable::OfAnisotropic(params_.surface, MirrorFacet);
  params_.is_brushed = true;
}

PhongTerms ConductorMaterial::Phong(const SurfacePoint& point) const {
  const float alpha = params_.is_brushed
                          ? std::max(params_.surface.alpha_x, params_.surface.alpha_y)
                          : roughness_.AlphaAt(point);
  const Rgb head_on = MetalReflectance(params_.eta, params_.k, FilmAt(point), 1);
  return {{}, {}, head_on, ShininessOf(alpha)};
}

FilmParams ConductorMaterial::FilmAt(const SurfacePoint& point) const {
  if (!film_) return {};
  FilmParams film{};
  film.table = film_table_.get();
  film.row = film_table_->RowOf(film_->ThicknessAt(point));
  return film;
}

void ConductorMaterial::Evaluate(const SurfacePoint& point, Bsdf* bsdf) const {
  Lobe lobe{LobeKind::kConductor, 1, Spectrum(1)};
  lobe.conductor = params_;
  lobe.conductor.energy = energy_ ? &*energy_ : nullptr;
  if (film_) {
    const FilmParams film = FilmAt(point);
    lobe.conductor.film = film;
    lobe.conductor.mean_fresnel = Min(params_.mean_fresnel + film.table->Mean(film.row), {1, 1, 1});
  }
  if (params_.is_brushed) {
    bsdf->frame = Frame::FromNormalAndTangent(bsdf->frame.z, point.dpdu);
    // The frame is mirrored on the inside, and what is turned in it with it.
    const bool is_outside = Dot(point.n_shading, bsdf->frame.z) > 0;
    if (!is_outside) lobe.conductor.sin_rotation = -params_.sin_rotation;
  } else {
    const float alpha = roughness_.AlphaAt(point);
    if (alpha < kSmoothestAlpha) lobe.kind = LobeKind::kSmoothConductor;
    lobe.conductor.surface = {alpha, alpha};
    lobe.conductor.table_row = roughness_.TableRow(alpha);
  }
  bsdf->Add(lobe);
}

}  // namespace candela
