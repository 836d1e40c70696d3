#pragma once

#include <functional>
#include <memory>
#include <ostream>
#include <vector>

#include "materials/conductor.h"
#include "materials/dielectric.h"
#include "materials/diffuse.h"
#include "materials/material.h"
#include "materials/phong.h"
#include "materials/plastic.h"

namespace candela::test {

/// A family of materials over a roughness from 0 to 1.
struct Family {
  const char* name;
  std::function<std::unique_ptr<Material>(float roughness)> create;
  bool is_outside = true;
};

inline std::vector<Family> Families() {
  const Rgb eta{0.14f, 0.37f, 1.44f}, k{3.98f, 2.39f, 1.6f};
  const auto glass = [](float r) {
    return std::make_unique<DielectricMaterial>(Medium{1.5f, {}}, Roughness::OfAlpha(r * r));
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
      {"BrushedConductor",
       [=](float r) {
         return std::make_unique<ConductorMaterial>(eta, k, Ggx{r * r, 0.3f * r * r + 0.1f}, 25.0f);
       }},
      {"GlassFromOutside", glass},
      {"GlassFromInside", glass, false},
      {"Plastic",
       [](float r) {
         return std::make_unique<PlasticMaterial>(Rgb{0.7f, 0.4f, 0.1f}, 1.5f,
                                                  Roughness::OfAlpha(r * r));
       }},
      {"PolishedPlastic",
       [](float) {
         return std::make_unique<PlasticMaterial>(Rgb{0.7f, 0.4f, 0.1f}, 1.5f, Roughness());
       }},
  };
}

inline void PrintTo(const Family& family, std::ostream* out) {
  *out << family.name;
}

}  // namespace candela::test
