// Sampling of all lobes at many angles and roughnesses; the contract tests have one of each.

#include <gtest/gtest.h>

#include <span>
#include <string>

#include "tests/materials/families.h"
#include "tests/materials/scatter.h"
#include "tests/support/effort.h"

namespace candela {
namespace {

using test::BsdfOf;
using test::DirectionAt;
using test::ExpectSamplesToFollowTheDensity;
using test::ExpectWeightsToAgree;
using test::Families;
using test::Family;
using test::kIncidences;
using test::UniformNumbers;
using testing_support::kIsSanitized;

const Vec3 kNormal = Normalize(Vec3{-2, 1, 2});

constexpr float kAllRoughness[] = {0.5f, 0.3f, 0.75f, 1};
constexpr auto kRoughness = std::span(kAllRoughness).first(kIsSanitized ? 1 : 4);
/// A density that is 6 percent too high in one half of the cells and too low in the other is found,
/// at each roughness and angle.
constexpr uint32_t kSamples = 100'000;

class EveryLobe : public testing::TestWithParam<Family> {};

INSTANTIATE_TEST_SUITE_P(Materials, EveryLobe, testing::ValuesIn(Families()),
                         [](const auto& row) { return std::string(row.param.name); });

template <class Check>
void ForEachCase(const Family& family, const Check& check) {
  for (const float roughness : kRoughness) {
    const auto material = family.create(roughness);
    const Bsdf bsdf = BsdfOf(*material, kNormal, family.is_outside);
    for (const double degrees : kIncidences) {
      SCOPED_TRACE(testing::Message() << "roughness " << roughness << " at " << degrees);
      check(bsdf, DirectionAt(bsdf.frame, degrees));
    }
  }
}

// P1
TEST_P(EveryLobe, SamplesFollowTheDensity) {
  UniformNumbers random(23);
  ForEachCase(GetParam(), [&](const Bsdf& bsdf, Vec3 wo) {
    ExpectSamplesToFollowTheDensity(bsdf, wo, kSamples, &random);
  });
}

// P2
TEST_P(EveryLobe, WeightIsValueTimesCosineOverDensity) {
  UniformNumbers random(29);
  ForEachCase(GetParam(),
              [&](const Bsdf& bsdf, Vec3 wo) { ExpectWeightsToAgree(bsdf, wo, 2000, &random); });
}

// P5: light that goes back takes the same way; through a boundary, by n^2: what the other side sees
// of it is as much brighter as its index is larger.
TEST_P(EveryLobe, IsReciprocal) {
  UniformNumbers random(31);
  for (const float roughness : kRoughness) {
    const auto material = GetParam().create(roughness);
    const Bsdf here = BsdfOf(*material, kNormal, GetParam().is_outside);
    const Bsdf beyond = BsdfOf(*material, kNormal, !GetParam().is_outside);
    for (const double degrees : kIncidences) {
      const Vec3 wo = DirectionAt(here.frame, degrees);
      for (int i = 0; i < 1000; ++i) {
        const BsdfSample sample = Sample(here, wo, random.NextPair());
        if (sample.pdf == 0 || sample.is_delta) continue;
        const Spectrum there = Eval(here, wo, sample.wi) * (sample.eta * sample.eta);
        const Spectrum back = Eval(sample.is_transmission ? beyond : here, sample.wi, wo);
        // A refracting facet is found by a difference, which has fewer digits.
        const float tolerance = sample.is_transmission ? 2e-4f : 1e-5f;
        for (int c = 0; c < 3; ++c) {
          ASSERT_NEAR(there[c], back[c], tolerance * there[c] + 1e-7f)
              << "roughness " << roughness << " at " << degrees
              << (sample.is_transmission ? " through" : "");
        }
      }
    }
  }
}

}  // namespace
}  // namespace candela
