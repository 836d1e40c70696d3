#include "materials/conductor.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "base/text.h"
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

/// `alpha_x` and `alpha_y`, or `roughness` in both directions.
Ggx ReadSurface(ParamReader* params) {
  const float roughness = params->Fraction("roughness", 0);
  const float alpha = roughness * roughness;
  const Ggx surface{params->Fraction("alpha_x", alpha), params->Fraction("alpha_y", alpha)};
  const bool is_anisotropic = params->Has("alpha_x") || params->Has("alpha_y");
  if (is_anisotropic && params->Has("roughness")) {
    params->Error(params->Where("roughness"),
                  "roughness is given by 'roughness' or by 'alpha_x' and 'alpha_y', not by both");
  } else if (params->Has("alpha_x") != params->Has("alpha_y")) {
    params->Error(params->Where(params->Has("alpha_x") ? "alpha_x" : "alpha_y"),
                  "'alpha_x' and 'alpha_y' are given together");
  }
  return surface;
}

}  // namespace

std::unique_ptr<Material> ConductorMaterial::Create(ParamReader* params) {
  const Metal metal = ReadMetal(params);
  const Ggx surface = ReadSurface(params);
  return std::make_unique<ConductorMaterial>(metal.eta, metal.k, surface,
                                             params->Number("rotation", 0));
}

ConductorMaterial::ConductorMaterial(Rgb eta, Rgb k, Ggx surface, float rotation_degrees)
    : params_{eta,
              k,
              MeanConductorReflectance(eta, k),
              surface,
              static_cast<float>(CosDegrees(static_cast<double>(rotation_degrees))),
              static_cast<float>(SinDegrees(static_cast<double>(rotation_degrees))),
              nullptr,
              0} {
  if (std::max(surface.alpha_x, surface.alpha_y) < kSmoothestAlpha) return;
  params_.surface.alpha_x = std::max(surface.alpha_x, kSmoothestAlpha);
  params_.surface.alpha_y = std::max(surface.alpha_y, kSmoothestAlpha);
  energy_ = surface.alpha_x == surface.alpha_y
                ? EnergyTable::OfRoughness(surface.alpha_x, MirrorFacet)
                : EnergyTable::OfAnisotropic(params_.surface, MirrorFacet);
  params_.energy = &*energy_;
}

PhongTerms ConductorMaterial::Phong(const SurfacePoint&) const {
  const float alpha = std::max(params_.surface.alpha_x, params_.surface.alpha_y);
  return {{}, {}, ConductorReflectance(1, params_.eta, params_.k), ShininessOf(alpha)};
}

void ConductorMaterial::Evaluate(const SurfacePoint&, Bsdf* bsdf) const {
  Lobe lobe{energy_ ? LobeKind::kConductor : LobeKind::kSmoothConductor, 1, Spectrum(1)};
  lobe.conductor = params_;
  bsdf->Add(lobe);
}

}  // namespace candela
