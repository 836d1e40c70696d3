// What surfaces give back of the light they get: all of it where nothing absorbs.

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "materials/conductor.h"
#include "materials/diffuse.h"
#include "materials/mirror.h"
#include "materials/pane.h"
#include "materials/phong.h"
#include "materials/plastic.h"
#include "materials/retroreflective.h"
#include "tests/materials/white_furnace.h"

namespace candela::test {
namespace {

/// A metal that absorbs nothing.
ConductorMaterial WhiteMetal(float alpha) {
  return {{0, 0, 0}, {3, 3, 3}, Roughness::OfAlpha(alpha)};
}
ConductorMaterial BrushedWhiteMetal(Ggx surface, float rotation_degrees = 0) {
  return {{0, 0, 0}, {3, 3, 3}, surface, rotation_degrees};
}

// P4
TEST(WhiteFurnace, MirrorsLoseNothing) {
  ExpectWhite(MirrorMaterial(Rgb{1, 1, 1}), 1e-6);
  ExpectWhite(WhiteMetal(0), 1e-6);
}

// P4
TEST(WhiteFurnace, DiffuseLosesNothingHoweverRough) {
  for (const float roughness : {0.0f, 0.25f, 0.5f, 0.75f, 1.0f}) {
    ExpectWhite(DiffuseMaterial(Rgb{1, 1, 1}, roughness), 1e-5);
  }
}

// P4
TEST(WhiteFurnace, RoughMetalLosesNothing) {
  for (const float alpha : kAlphas) ExpectWhite(WhiteMetal(alpha), 2e-3);
}

// P4
TEST(WhiteFurnace, BrushedMetalLosesNothing) {
  ExpectWhite(BrushedWhiteMetal({0.5f, 0.1f}, 30), 2e-3);
  ExpectWhite(BrushedWhiteMetal({0.05f, 0.9f}), 2e-3);
}

// P4
TEST(WhiteFurnace, WhitePlasticLosesNothing) {
  for (const float alpha : {0.0f, 0.01f, 0.1f, 0.25f, 0.5f, 1.0f}) {
    ExpectWhite(PlasticMaterial(Rgb{1, 1, 1}, 1.5f, Roughness::OfAlpha(alpha)), 2e-3);
  }
}

// P4
TEST(WhiteFurnace, RetroreflectorLosesNothing) {
  for (const float alpha : kAlphas) {
    ExpectWhite(RetroreflectiveMaterial(Rgb{1, 1, 1}, Rgb{1, 1, 1}, 1, Roughness::OfAlpha(alpha)),
                2e-3);
  }
}

/// What a white metal gives back after one bounce, by a fine grid of the facets that `wo` sees.
double OneBounceAlbedo(float alpha, Vec3 wo) {
  constexpr int kSteps = 1000;
  const Ggx surface{alpha, alpha};
  double sum = 0;
  for (int i = 0; i < kSteps; ++i) {
    for (int j = 0; j < kSteps; ++j) {
      const Vec2 u{(static_cast<float>(i) + 0.5f) / kSteps,
                   (static_cast<float>(j) + 0.5f) / kSteps};
      sum += static_cast<double>(MirrorFacet(surface, wo, surface.SampleVisible(wo, u)));
    }
  }
  return sum / (kSteps * kSteps);
}

// CF38: alpha = 1 at 0 degrees: 1 - ln 2; the others by integration over the hemisphere in double.
// The table is made of fewer facets and of straight lines.
TEST(RoughMetal, OneBounceGivesBackTheAlbedoOfGgx) {
  const struct {
    float alpha;
    double albedo[3];
  } cases[] = {{1, {0.306853, 0.376775, 0.590600}},
               {0.5f, {0.687849, 0.682774, 0.761370}},
               {0.25f, {0.915812, 0.886244, 0.839328}},
               {0.1f, {0.988304, 0.981685, 0.924417}}};
  for (const auto& [alpha, albedo] : cases) {
    const EnergyTable table =
        EnergyTable::OfRoughness(alpha, MirrorFacet, EnergyTable::Detail::kSmooth);
    for (int i = 0; i < 3; ++i) {
      const double degrees[] = {0, 45, 75};
      const Vec3 wo = DirectionAt(Frame(), degrees[i]);
      EXPECT_NEAR(OneBounceAlbedo(alpha, wo), albedo[i], 5e-5) << alpha << " at " << degrees[i];
      EXPECT_NEAR(table.At(wo.z, 0), albedo[i], 1.5e-3) << alpha << " at " << degrees[i];
    }
  }
}

// Rows for all roughnesses stand between those of each.
TEST(RoughMetal, TableOfAllRoughnessesAgreesWithThoseOfEach) {
  const EnergyTable all = EnergyTable::OfAllRoughness(MirrorFacet, EnergyTable::Detail::kSmooth);
  for (const float roughness : {0.25f, 0.37f, 0.5f, 0.77f, 0.9f, 1.0f}) {
    const float alpha = roughness * roughness;
    const EnergyTable one =
        EnergyTable::OfRoughness(alpha, MirrorFacet, EnergyTable::Detail::kSmooth);
    const float row = EnergyTable::RowOfRoughness(alpha);
    EXPECT_NEAR(all.Mean(row), one.Mean(0), 1e-3) << roughness;
    for (const float cosine : {0.01f, 0.1f, 0.3f, 0.7f, 1.0f}) {
      EXPECT_NEAR(all.At(cosine, row), one.At(cosine, 0), 3e-3) << roughness << " at " << cosine;
    }
  }
}

TEST(BrushedMetal, HasARowForEachAzimuthFoundInEitherWay) {
  for (int degrees = 0; degrees < 360; ++degrees) {
    const Vec3 w = DirectionAt(Frame(), 60, degrees + 0.3);
    EXPECT_NEAR(EnergyTable::NearRowOfAzimuth(w), EnergyTable::RowOfAzimuth(w), 2e-4f) << degrees;
  }
  EXPECT_EQ(EnergyTable::NearRowOfAzimuth({0, 0, 1}), 0);
}

// CF33: (n + 2) / 2 pi is the factor with which the lobe head-on gives back its weight, for any n.
TEST(NormalisedPhong, HeadOnItReflectsItsSpecularColour) {
  UniformNumbers random(5);
  for (const float exponent : {0.0f, 1.0f, 20.0f, 500.0f}) {
    const PhongMaterial material({{}, {}, {0.5f, 0.25f, 1}, exponent}, true);
    const Bsdf bsdf = BsdfOf(material, kNormal);
    const Albedo albedo = AlbedoOf(bsdf, kNormal, 200000, &random);
    for (int c = 0; c < 3; ++c) {
      const double expected = c == 0 ? 0.5 : c == 1 ? 0.25 : 1;
      EXPECT_NEAR(albedo.mean[c], expected, kLargestDeviate * albedo.error[c]) << exponent;
    }
  }
}

// P5
TEST(Energy, NoMaterialMakesLight) {
  UniformNumbers random(11);
  std::unique_ptr<Material> materials[] = {
      std::make_unique<DiffuseMaterial>(Rgb{0.9f, 0.5f, 0.1f}, 0.7f),
      std::make_unique<ConductorMaterial>(Rgb{0.14f, 0.37f, 1.44f}, Rgb{3.98f, 2.39f, 1.6f},
                                          Roughness::OfAlpha(0.4f)),
      std::make_unique<PlasticMaterial>(Rgb{0.9f, 0.5f, 0.1f}, 1.5f, Roughness::OfAlpha(0.2f)),
      std::make_unique<PaneMaterial>(1.5f, Rgb{0, 0.5f, 1}),
      std::make_unique<PhongMaterial>(PhongTerms{{}, {0.5f, 0.5f, 0.5f}, {0.5f, 0.4f, 0.3f}, 30},
                                      true)};
  for (const auto& material : materials) {
    const Bsdf bsdf = BsdfOf(*material, kNormal);
    for (int step = 0; step < 32; ++step) {
      const double degrees = 89.5 * step / 31;
      const Albedo albedo = AlbedoOf(bsdf, DirectionAt(bsdf.frame, degrees), 4000, &random);
      for (int c = 0; c < 3; ++c) {
        EXPECT_LE(albedo.mean[c], 1 + 2e-3 + kLargestDeviate * albedo.error[c]) << degrees;
      }
    }
  }
}

}  // namespace
}  // namespace candela::test
