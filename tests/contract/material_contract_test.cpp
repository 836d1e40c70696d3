// What holds for every material that light transport may use, and the list of those it may not.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "math/elementary.h"
#include "sampling/warp.h"
#include "tests/contract/rows.h"
#include "tests/sampling/chi_square.h"

namespace candela {
namespace {

using contract::SceneOfMaterial;
using test::ChiSquareDeviate;
using test::kLargestDeviate;
using test::UniformNumbers;

const Material& MaterialOf(const Scene& scene) {
  return *scene.materials()[0];
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
  EveryPhysicalMaterial() : scene_(SceneOfMaterial(GetParam().example)) {
    bsdf_.frame = Frame::FromNormal(Normalize(Vec3{1, -2, 3}));
    SurfacePoint point;
    point.n_geometric = point.n_shading = bsdf_.frame.z;
    MaterialOf(*scene_).Evaluate(point, &bsdf_);
  }

  /// A direction at `degrees` from the normal.
  Vec3 At(double degrees, double azimuth = 0.7) const {
    return bsdf_.frame.ToWorld(ToFloat({SinDegrees(degrees) * Cos(azimuth),
                                        SinDegrees(degrees) * Sin(azimuth), CosDegrees(degrees)}));
  }

  std::unique_ptr<const Scene> scene_;
  Bsdf bsdf_;
  UniformNumbers random_{3};
};

INSTANTIATE_TEST_SUITE_P(Registry, EveryPhysicalMaterial, testing::ValuesIn(Rows(true)),
                         contract::RowName<MaterialEntry>);

constexpr double kAngles[] = {0, 15, 30, 45, 60, 75, 85, 89};

TEST_P(EveryPhysicalMaterial, WeightIsValueTimesCosineOverDensity) {
  for (const double degrees : kAngles) {
    const Vec3 wo = At(degrees);
    int drawn = 0;
    for (int i = 0; i < 10000; ++i) {
      const BsdfSample sample = Sample(bsdf_, wo, random_.NextPair());
      if (sample.pdf == 0) continue;
      ++drawn;
      EXPECT_NEAR(Length(sample.wi), 1, 1e-5);
      if (sample.pdf < 1e-3f) continue;  // So near the horizon the cosine has few digits.
      EXPECT_NEAR(Pdf(bsdf_, wo, sample.wi), sample.pdf, 1e-3f * sample.pdf);
      const float cosine = std::abs(Dot(bsdf_.frame.z, sample.wi));
      const Spectrum expected = Eval(bsdf_, wo, sample.wi) * (cosine / sample.pdf);
      for (int c = 0; c < 3; ++c) EXPECT_NEAR(sample.weight[c], expected[c], 1e-3f);
    }
    EXPECT_GT(drawn, 5000) << degrees;
  }
}

// 1e6 samples at each angle, in 16 x 32 cells of equal solid angle of the whole sphere. Strength:
// see chi_square.h.
TEST_P(EveryPhysicalMaterial, SamplesFollowTheDensity) {
  constexpr size_t kHeights = 16, kSectors = 32, kSteps = 8;
  for (const double degrees : {0.0, 45.0, 89.0}) {
    const Vec3 wo = At(degrees);
    const auto direction = [&](double height, double turn) {
      const double radius = std::sqrt(1 - height * height);
      const Vec3d local{radius * Cos(turn), radius * Sin(turn), height};
      return bsdf_.frame.ToWorld(ToFloat(local));
    };

    std::vector<double> shares(kHeights * kSectors);
    double sum = 0;
    const double cell = 4 * kPi / static_cast<double>(kHeights * kSectors * kSteps * kSteps);
    for (size_t i = 0; i < kHeights * kSteps; ++i) {
      for (size_t j = 0; j < kSectors * kSteps; ++j) {
        const double height = 2 * (static_cast<double>(i) + 0.5) / (kHeights * kSteps) - 1;
        const double turn = 2 * kPi * (static_cast<double>(j) + 0.5) / (kSectors * kSteps);
        const double share = static_cast<double>(Pdf(bsdf_, wo, direction(height, turn))) * cell;
        shares[i / kSteps * kSectors + j / kSteps] += share;
        sum += share;
      }
    }
    EXPECT_NEAR(sum, 1, 1e-3) << "the density does not integrate to 1";
    for (double& share : shares) share /= sum;

    std::vector<uint64_t> counts(shares.size());
    for (int i = 0; i < 1000000; ++i) {
      const BsdfSample sample = Sample(bsdf_, wo, random_.NextPair());
      if (sample.pdf == 0) continue;
      const Vec3 local = bsdf_.frame.ToLocal(sample.wi);
      double turn = std::atan2(static_cast<double>(local.y), static_cast<double>(local.x));
      if (turn < 0) turn += 2 * kPi;
      const auto index = [](double position, size_t size) {
        const double at = position * static_cast<double>(size);
        return std::min(static_cast<size_t>(std::max(at, 0.0)), size - 1);
      };
      const size_t height = index((static_cast<double>(local.z) + 1) / 2, kHeights);
      ++counts[height * kSectors + index(turn / (2 * kPi), kSectors)];
    }
    EXPECT_LT(ChiSquareDeviate(counts, shares), kLargestDeviate) << degrees;
  }
}

TEST_P(EveryPhysicalMaterial, IsReciprocal) {
  for (int i = 0; i < 100000; ++i) {
    const Vec3 wo = SampleUniformSphere(random_.NextPair());
    const Vec3 wi = SampleUniformSphere(random_.NextPair());
    const Spectrum there = Eval(bsdf_, wo, wi), back = Eval(bsdf_, wi, wo);
    for (int c = 0; c < 4; ++c) {
      ASSERT_GE(there[c], 0.0f);
      ASSERT_NEAR(there[c], back[c], 1e-5f * std::abs(there[c]));
    }
  }
}

TEST_P(EveryPhysicalMaterial, ReflectsNoMoreThanItGets) {
  for (const double degrees : kAngles) {
    const Vec3 wo = At(degrees);
    double albedo[3] = {};
    constexpr int kSamples = 20000;
    for (int i = 0; i < kSamples; ++i) {
      const BsdfSample sample = Sample(bsdf_, wo, random_.NextPair());
      for (int c = 0; c < 3; ++c) albedo[c] += static_cast<double>(sample.weight[c]) / kSamples;
    }
    for (const double channel : albedo) EXPECT_LE(channel, 1 + 1e-6) << degrees;
    EXPECT_GT(albedo[0] + albedo[1] + albedo[2], 0) << degrees;
  }
}

}  // namespace
}  // namespace candela
