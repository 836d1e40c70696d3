// What holds for every material that light transport may use, and the list of those it may not.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "sampling/warp.h"
#include "tests/contract/rows.h"
#include "tests/materials/scatter.h"

namespace candela {
namespace {

using contract::SceneOfMaterial;
using test::Albedo;
using test::AlbedoOf;
using test::BsdfOf;
using test::DirectionAt;
using test::ExpectSamplesToFollowTheDensity;
using test::ExpectWeightsToAgree;
using test::kIncidences;
using test::kLargestDeviate;
using test::UniformNumbers;

const Material& MaterialOf(const Scene& scene) {
  return *scene.materials().back();
}

std::vector<MaterialEntry> Rows(bool are_physical) {
  std::vector<MaterialEntry> rows;
  for (const MaterialEntry& entry : MaterialEntries()) {
    const auto scene = SceneOfMaterial(entry.example);
    if (MaterialOf(*scene).IsPhysical() == are_physical) rows.push_back(entry);
  }
  return rows;
}

// The tests of light transport below do not apply to these rows.
TEST(MaterialContract, TheseRowsAreNotPhysical) {
  std::vector<std::string_view> names;
  for (const MaterialEntry& entry : Rows(false)) names.push_back(entry.name);
  EXPECT_THAT(names, testing::ElementsAre("phong"));
}

class EveryMaterial : public testing::TestWithParam<MaterialEntry> {};

INSTANTIATE_TEST_SUITE_P(Registry, EveryMaterial,
                         testing::ValuesIn(MaterialEntries().begin(), MaterialEntries().end()),
                         contract::RowName<MaterialEntry>);

TEST_P(EveryMaterial, HasPhongTermsForWhitted) {
  const auto scene = SceneOfMaterial(GetParam().example);
  const PhongTerms terms = MaterialOf(*scene).Phong({});
  EXPECT_TRUE(IsFinite(terms.ambient) && IsFinite(terms.diffuse) && IsFinite(terms.specular));
  EXPECT_TRUE(std::isfinite(terms.shininess));
  EXPECT_GT(LengthSquared(terms.diffuse) + LengthSquared(terms.specular), 0);
}

class EveryPhysicalMaterial : public testing::TestWithParam<MaterialEntry> {
 protected:
  EveryPhysicalMaterial()
      : scene_(SceneOfMaterial(GetParam().example)),
        bsdf_(BsdfOf(MaterialOf(*scene_), Normalize(Vec3{1, -2, 3}))) {}

  std::unique_ptr<const Scene> scene_;
  Bsdf bsdf_;
  UniformNumbers random_{3};
};

INSTANTIATE_TEST_SUITE_P(Registry, EveryPhysicalMaterial, testing::ValuesIn(Rows(true)),
                         contract::RowName<MaterialEntry>);

TEST_P(EveryPhysicalMaterial, DrawsFromAllAngles) {
  for (const double degrees : kIncidences) {
    int drawn = 0;
    for (int i = 0; i < 10000; ++i) {
      drawn += Sample(bsdf_, DirectionAt(bsdf_.frame, degrees), random_.NextPair()).pdf > 0;
    }
    EXPECT_GT(drawn, 5000) << degrees;
  }
}

// P2
TEST_P(EveryPhysicalMaterial, WeightIsValueTimesCosineOverDensity) {
  for (const double degrees : kIncidences) {
    ExpectWeightsToAgree(bsdf_, DirectionAt(bsdf_.frame, degrees), 10000, &random_);
  }
}

// P1
TEST_P(EveryPhysicalMaterial, SamplesFollowTheDensity) {
  for (const double degrees : {0.0, 45.0, 89.0}) {
    SCOPED_TRACE(degrees);
    const Vec3 wo = DirectionAt(bsdf_.frame, degrees);
    ExpectSamplesToFollowTheDensity(bsdf_, wo, 1000000, &random_);
  }
}

TEST_P(EveryPhysicalMaterial, SaysWhetherItHasASmoothPart) {
  bool is_smooth = false;
  for (int i = 0; i < 1000; ++i) {
    const BsdfSample sample = Sample(bsdf_, DirectionAt(bsdf_.frame, 45), random_.NextPair());
    is_smooth = is_smooth || (sample.pdf > 0 && !sample.is_delta);
  }
  EXPECT_EQ(bsdf_.HasSmoothPart(), is_smooth);
}

// P5: through the surface by the square of the refractive indices.
TEST_P(EveryPhysicalMaterial, IsReciprocal) {
  const Bsdf beyond = BsdfOf(MaterialOf(*scene_), bsdf_.frame.z, false);
  for (int i = 0; i < 100000; ++i) {
    const Vec3 wo = SampleUniformSphere(random_.NextPair());
    const Vec3 wi = SampleUniformSphere(random_.NextPair());
    const Spectrum there = Eval(bsdf_, wo, wi);
    for (int c = 0; c < 4; ++c) ASSERT_GE(there[c], 0.0f);
    if (Dot(bsdf_.frame.z, wi) < 0) continue;
    const Spectrum back = Eval(bsdf_, wi, wo);
    for (int c = 0; c < 4; ++c) {
      if (Dot(bsdf_.frame.z, wo) < 0) continue;
      ASSERT_NEAR(there[c], back[c], 1e-5f * std::abs(there[c]));
    }
  }
  for (int i = 0; i < 10000; ++i) {
    const Vec3 wo = DirectionAt(bsdf_.frame, 80.0 * random_.NextPair().x);
    const BsdfSample sample = Sample(bsdf_, wo, random_.NextPair());
    if (sample.pdf == 0 || sample.is_delta || !sample.is_transmission) continue;
    const Spectrum there = Eval(bsdf_, wo, sample.wi) * (sample.eta * sample.eta);
    const Spectrum back = Eval(beyond, sample.wi, wo);
    for (int c = 0; c < 4; ++c) ASSERT_NEAR(there[c], back[c], 2e-5f * there[c]);
  }
}

// P5: by the error of the estimate, and by that of the tables of rough surfaces.
TEST_P(EveryPhysicalMaterial, ReflectsNoMoreThanItGets) {
  for (const double degrees : kIncidences) {
    const Albedo albedo = AlbedoOf(bsdf_, DirectionAt(bsdf_.frame, degrees), 20000, &random_);
    for (int c = 0; c < 3; ++c) {
      EXPECT_LE(albedo.mean[c], 1 + 2e-3 + kLargestDeviate * albedo.error[c]) << degrees;
    }
    EXPECT_GT(albedo.mean[0] + albedo.mean[1] + albedo.mean[2], 0) << degrees;
  }
}

}  // namespace
}  // namespace candela
