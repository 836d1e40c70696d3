#pragma once

#include <functional>
#include <memory>
#include <ostream>
#include <span>
#include <utility>
#include <vector>

#include "materials/conductor.h"
#include "materials/dielectric.h"
#include "materials/diffuse.h"
#include "materials/material.h"
#include "materials/phong.h"
#include "materials/plastic.h"
#include "materials/principled.h"
#include "materials/retroreflective.h"

namespace candela::test {

/// A family of materials over a roughness from 0 to 1.
struct Family {
  const char* name;
  std::function<std::unique_ptr<Material>(float roughness)> create;
  bool is_outside = true;
};

/// A `principled` material with something of everything opaque.
inline PrincipledMaterial::Inputs AllLayers(float roughness) {
  PrincipledMaterial::Inputs inputs;
  inputs.base_color = Rgb{0.7f, 0.4f, 0.1f};
  inputs.metallic = 0.4f;
  inputs.roughness = Roughness::OfAlpha(roughness * roughness);
  inputs.specular = 0.8f;
  inputs.specular_tint = 0.5f;
  inputs.clearcoat = 0.6f;
  inputs.clearcoat_roughness = Roughness::OfAlpha(0.09f);
  inputs.sheen = 0.5f;
  inputs.sheen_tint = 0.5f;
  inputs.sheen_roughness = 0.4f;
  return inputs;
}

inline std::vector<Family> Families() {
  const Rgb eta{0.14f, 0.37f, 1.44f}, k{3.98f, 2.39f, 1.6f};
  const auto glass = [](float r) {
    return std::make_unique<DielectricMaterial>(Medium{1.5f, {}}, Roughness::OfAlpha(r * r));
  };
  const auto filmed_glass = [](float r) {
    return std::make_unique<DielectricMaterial>(Medium{1.5f, {}}, Roughness::OfAlpha(r * r),
                                                std::span<const Medium>(), FilmInput(1.7f, 200));
  };
  return {
      {"Diffuse",
       [](float r) {
         return std::make_unique<DiffuseMaterial>(Rgb{0.8f, 0.5f, 0.2f}, r);
       }},
      {"NormalisedPhong",
       [](float r) {
         const PhongTerms terms{{}, {0.3f, 0.2f, 0.1f}, {0.6f, 0.6f, 0.6f}, 2 / (r * r)};
         return std::make_unique<PhongMaterial>(terms, true);
       }},
      {"Conductor",
       [=](float r) {
         return std::make_unique<ConductorMaterial>(eta, k, Roughness::OfAlpha(r * r));
       }},
      {"FilmOnConductor",
       [=](float r) {
         return std::make_unique<ConductorMaterial>(eta, k, Roughness::OfAlpha(r * r),
                                                    FilmInput(1.8f, 300));
       }},
      {"BrushedConductor",
       [=](float r) {
         return std::make_unique<ConductorMaterial>(eta, k, Ggx{r * r, 0.3f * r * r + 0.1f}, 25.0f);
       }},
      {"GlassFromOutside", glass},
      {"GlassFromInside", glass, false},
      {"GlassWithFilmFromOutside", filmed_glass},
      {"GlassWithFilmFromInside", filmed_glass, false},
      {"Plastic",
       [](float r) {
         return std::make_unique<PlasticMaterial>(Rgb{0.7f, 0.4f, 0.1f}, 1.5f,
                                                  Roughness::OfAlpha(r * r));
       }},
      {"PolishedPlastic",
       [](float) {
         return std::make_unique<PlasticMaterial>(Rgb{0.7f, 0.4f, 0.1f}, 1.5f, Roughness());
       }},
      {"Retroreflective",
       [](float r) {
         return std::make_unique<RetroreflectiveMaterial>(Rgb{0.7f, 0.4f, 0.1f}, Rgb{0.9f, 0.9f, 1},
                                                          0.6f, Roughness::OfAlpha(r * r));
       }},
      {"Principled",
       [](float r) {
         PrincipledMaterial::Inputs inputs;
         inputs.base_color = Rgb{0.7f, 0.4f, 0.1f};
         inputs.roughness = Roughness::OfAlpha(r * r);
         return std::make_unique<PrincipledMaterial>(std::move(inputs));
       }},
      {"PrincipledOfAllLayers",
       [](float r) { return std::make_unique<PrincipledMaterial>(AllLayers(r)); }},
      {"BrushedPrincipled",
       [](float r) {
         PrincipledMaterial::Inputs inputs = AllLayers(0.5f);
         inputs.anisotropy = r;
         inputs.rotation_degrees = 25;
         return std::make_unique<PrincipledMaterial>(std::move(inputs));
       }},
      {"GlassPrincipled",
       [](float r) {
         PrincipledMaterial::Inputs inputs = AllLayers(r);
         inputs.transmission = 0.7f;
         return std::make_unique<PrincipledMaterial>(std::move(inputs));
       }},
  };
}

inline void PrintTo(const Family& family, std::ostream* out) {
  *out << family.name;
}

}  // namespace candela::test
