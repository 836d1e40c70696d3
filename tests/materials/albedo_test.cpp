// What materials reflect at 32 angles and 16 roughnesses, and that light may go both ways. The slow
// set has 32 roughnesses and knows it to a tenth of a percent; under sanitizers there are few.

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "materials/energy_store.h"
#include "sampling/sampler.h"
#include "sampling/warp.h"
#include "tests/materials/families.h"
#include "tests/materials/scatter.h"
#include "tests/support/effort.h"
#include "textures/constant_texture.h"

namespace candela {
namespace {

using test::BsdfOf;
using test::DirectionAt;
using test::Families;
using test::Family;
using test::kLargestDeviate;
using test::UniformNumbers;
using testing_support::kIsSanitized;
using testing_support::kIsSlow;

/// The largest error of an estimate, as a share of the light.
constexpr double kStrength = kIsSlow ? 1e-3 : 0.01;
constexpr int kAngles = kIsSanitized ? 6 : 32;
constexpr int kRoughnesses = kIsSanitized ? 4 : kIsSlow ? 32 : 16;
const Vec3 kNormal = Normalize(Vec3{2, 1, -2});

/// Those that absorb nothing: what they reflect is 1, and must not be more.
std::vector<Family> WhiteFamilies() {
  const Rgb white{1, 1, 1};
  return {
      {"WhiteDiffuse", [=](float r) { return std::make_unique<DiffuseMaterial>(white, r); }},
      {"WhiteConductor",
       [](float r) {
         return std::make_unique<ConductorMaterial>(Rgb{0, 0, 0}, Rgb{3, 3, 3},
                                                    Roughness::OfAlpha(r * r));
       }},
      {"WhiteBrushedConductor",
       [](float r) {
         return std::make_unique<ConductorMaterial>(Rgb{0, 0, 0}, Rgb{3, 3, 3},
                                                    Ggx{r * r, 0.3f * r * r + 0.1f}, 25.0f);
       }},
      {"WhiteConductorWithFilm",
       [](float r) {
         return std::make_unique<ConductorMaterial>(
             Rgb{0, 0, 0}, Rgb{3, 3, 3}, Roughness::OfAlpha(r * r), FilmInput(1.8f, 300));
       }},
      {"WhitePlastic",
       [=](float r) {
         return std::make_unique<PlasticMaterial>(white, 1.5f, Roughness::OfAlpha(r * r));
       }},
      {"WhiteNormalisedPhong",
       [](float r) {
         const PhongTerms terms{{}, {0.5f, 0.5f, 0.5f}, {0.5f, 0.5f, 0.5f}, 2 / (r * r)};
         return std::make_unique<PhongMaterial>(terms, true);
       }},
      {"WhiteRetroreflective",
       [=](float r) {
         return std::make_unique<RetroreflectiveMaterial>(white, white, 0.5f,
                                                          Roughness::OfAlpha(r * r));
       }},
      {"WhitePrincipled",
       [=](float r) {
         PrincipledMaterial::Inputs inputs = test::AllLayers(r);
         inputs.base_color = white;
         inputs.clearcoat = inputs.specular = inputs.sheen = 1;
         return std::make_unique<PrincipledMaterial>(std::move(inputs));
       }},
      {"WhiteCoatedPrincipled",
       [=](float r) {
         PrincipledMaterial::Inputs inputs;
         inputs.base_color = white;
         inputs.clearcoat = 1;
         inputs.clearcoat_roughness = Roughness::OfAlpha(r * r);
         return std::make_unique<PrincipledMaterial>(std::move(inputs));
       }},
      {"WhiteSheenPrincipled",
       [=](float r) {
         PrincipledMaterial::Inputs inputs;
         inputs.base_color = white;
         inputs.sheen = 1;
         inputs.sheen_roughness = r;
         return std::make_unique<PrincipledMaterial>(std::move(inputs));
       }},
      {"GlassOfTexturedRoughness",
       // All of them have the same table.
       [energies = std::make_shared<EnergyStore>()](float r) {
         auto roughness = std::make_shared<ConstantTexture>(Rgb{r, r, r});
         return std::make_unique<DielectricMaterial>(
             Medium{1.5f, {}}, Roughness::OfTexture(std::move(roughness)),
             std::span<const Medium>(), std::nullopt, energies.get());
       },
       false},
  };
}

std::vector<Family> AllFamilies() {
  std::vector<Family> all = Families();
  for (const Family& family : WhiteFamilies()) all.push_back(family);
  return all;
}

/// The largest component of the mean weight as a share of power, with its error.
struct Share {
  double mean = 0, error = 0;
};

/// By sets of evenly spread samples, whose means tell the error: as many samples as it takes to the
/// strength of the test, which differ by hundreds of times over angles and roughnesses.
class ShareEstimate {
 public:
  ShareEstimate(const Bsdf& bsdf, Vec3 wo) : bsdf_(bsdf), wo_(wo) {}

  Share Run() {
    // Fewer would not see that one of hundreds finds no light, and think themselves precise.
    constexpr uint32_t kFewest = kIsSlow ? 1024 : 128, kMost = 32768;
    Share share;
    for (uint32_t samples = kFewest; samples <= kMost; samples *= 2) {
      Continue(samples);
      share = Largest();
      if (share.error <= kStrength) break;
    }
    return share;
  }

 private:
  static constexpr uint32_t kSets = 16;

  void Continue(uint32_t samples) {
    for (uint32_t set = 0; set < kSets; ++set) {
      for (uint32_t i = samples_; i < samples; ++i) {
        const BsdfSample sample = Sample(bsdf_, wo_, Sampler(5, set, 0, i).Get2D(0));
        for (int c = 0; c < 3; ++c) {
          sums_[set][c] += static_cast<double>(sample.weight[c] * sample.eta * sample.eta);
        }
      }
    }
    samples_ = samples;
  }

  Share Largest() const {
    Share largest;
    for (int c = 0; c < 3; ++c) {
      double mean = 0, squares = 0;
      for (const auto& sum : sums_) {
        const double of_set = sum[c] / samples_;
        mean += of_set / kSets;
        squares += of_set * of_set / kSets;
      }
      if (mean <= largest.mean) continue;
      largest.mean = mean;
      largest.error = std::sqrt(std::max(0.0, squares - mean * mean) / (kSets - 1));
    }
    return largest;
  }

  const Bsdf& bsdf_;
  Vec3 wo_;
  uint32_t samples_ = 0;  ///< Of each set.
  double sums_[kSets][3] = {};
};

class EveryFamily : public testing::TestWithParam<Family> {};

INSTANTIATE_TEST_SUITE_P(Materials, EveryFamily, testing::ValuesIn(AllFamilies()),
                         [](const auto& row) { return std::string(row.param.name); });

// P5. Beyond the error of the estimate by 2e-3, which is that of the tables of rough surfaces.
TEST_P(EveryFamily, ReflectsNoMoreThanItGetsAtAnyAngleAndRoughness) {
  double largest_error = 0;
  for (int step = 1; step <= kRoughnesses; ++step) {
    const float roughness = static_cast<float>(step) / kRoughnesses;
    const auto material = GetParam().create(roughness);
    const Bsdf bsdf = BsdfOf(*material, kNormal, GetParam().is_outside);
    for (int i = 0; i < kAngles; ++i) {
      const double degrees = 89.5 * i / (kAngles - 1);
      const Share share = ShareEstimate(bsdf, DirectionAt(bsdf.frame, degrees)).Run();
      EXPECT_LE(share.mean, 1 + 2e-3 + kLargestDeviate * share.error)
          << "roughness " << roughness << " at " << degrees;
      EXPECT_GT(share.mean, 0) << "roughness " << roughness << " at " << degrees;
      largest_error = std::max(largest_error, share.error);
    }
  }
  EXPECT_LE(largest_error, kStrength) << "too noisy to tell";
}

// P5: by 1e-5 for what is reflected. A refracting facet is found by a difference, which has fewer
// digits. Through a boundary light that goes back is as much brighter as n^2 says.
TEST_P(EveryFamily, IsReciprocalForAnyPairOfDirections) {
  constexpr int kSteps = kIsSanitized ? 2 : 8, kPairs = (kIsSanitized ? 20'000 : 100'000) / kSteps;
  UniformNumbers random(37);
  int reflected = 0, through = 0;
  for (int step = 1; step <= kSteps; ++step) {
    const auto material = GetParam().create(static_cast<float>(step) / kSteps);
    const Bsdf here = BsdfOf(*material, kNormal, GetParam().is_outside);
    const Bsdf beyond = BsdfOf(*material, kNormal, !GetParam().is_outside);
    const float n_squared = GetParam().is_outside ? 1 / 2.25f : 2.25f;
    for (int i = 0; i < kPairs; ++i) {
      const Vec3 wo = here.frame.ToWorld(SampleUniformHemisphere(random.NextPair()));
      const Vec3 wi = SampleUniformSphere(random.NextPair());
      const bool is_through = Dot(here.frame.z, wi) < 0;
      const Spectrum there = Eval(here, wo, wi) * (is_through ? 1 / n_squared : 1);
      const Spectrum back = Eval(is_through ? beyond : here, wi, wo);
      const float tolerance = is_through ? 5e-4f : 1e-5f;
      for (int c = 0; c < 3; ++c) {
        ASSERT_NEAR(there[c], back[c], tolerance * there[c] + 1e-7f)
            << "step " << step << (is_through ? " through" : "");
      }
      if (!there.IsBlack()) ++(is_through ? through : reflected);
    }
  }
  EXPECT_GT(reflected, 0.4 * kSteps * kPairs);
  const bool is_glass = std::string(GetParam().name).starts_with("Glass");
  EXPECT_EQ(through > 0.01 * kSteps * kPairs, is_glass);
}

}  // namespace
}  // namespace candela
