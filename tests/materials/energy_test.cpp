// What surfaces give back of the light they get: all of it where nothing absorbs.

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <optional>

#include "materials/conductor.h"
#include "materials/dielectric.h"
#include "materials/diffuse.h"
#include "materials/mirror.h"
#include "materials/pane.h"
#include "materials/phong.h"
#include "materials/plastic.h"
#include "materials/principled.h"
#include "materials/retroreflective.h"
#include "math/wavelength.h"
#include "tests/materials/scatter.h"
#include "textures/constant_texture.h"

namespace candela {
namespace {

using test::Albedo;
using test::AlbedoOf;
using test::BsdfOf;
using test::DirectionAt;
using test::kIncidences;
using test::kLargestDeviate;
using test::UniformNumbers;

const Vec3 kNormal = Normalize(Vec3{1, -2, 3});
constexpr float kAlphas[] = {0.01f, 0.1f, 0.25f, 0.5f, 1};

/// The surface gives back everything, by `tolerance` beyond the error of the estimate. Above 1 it
/// would make light.
void ExpectWhite(const Bsdf& bsdf, double tolerance, double azimuth = 40) {
  UniformNumbers random(7);
  for (const double degrees : kIncidences) {
    const Albedo albedo = AlbedoOf(bsdf, DirectionAt(bsdf.frame, degrees, azimuth), 20000, &random);
    for (int c = 0; c < 3; ++c) {
      EXPECT_NEAR(albedo.mean[c], 1, tolerance + kLargestDeviate * albedo.error[c]) << degrees;
      EXPECT_LE(albedo.error[c], 0.02) << degrees << ": the estimate is too noisy to tell";
    }
  }
}

void ExpectWhite(const Material& material, double tolerance, bool is_outside = true) {
  ExpectWhite(BsdfOf(material, kNormal, is_outside), tolerance);
}

/// A metal that absorbs nothing.
ConductorMaterial WhiteMetal(float alpha) {
  return {{0, 0, 0}, {3, 3, 3}, Roughness::OfAlpha(alpha)};
}
ConductorMaterial BrushedWhiteMetal(Ggx surface, float rotation_degrees = 0) {
  return {{0, 0, 0}, {3, 3, 3}, surface, rotation_degrees};
}

DielectricMaterial Glass(float ior, float alpha) {
  return {{ior, {}}, Roughness::OfAlpha(alpha)};
}

// P4
TEST(WhiteFurnace, MirrorAndSmoothGlassLoseNothing) {
  ExpectWhite(MirrorMaterial(Rgb{1, 1, 1}), 1e-6);
  ExpectWhite(WhiteMetal(0), 1e-6);
  for (const bool is_outside : {true, false}) {
    ExpectWhite(Glass(1.5f, 0), 1e-6, is_outside);
    ExpectWhite(PaneMaterial(1.5f, {}), 1e-6, is_outside);
  }
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
TEST(WhiteFurnace, GroundGlassLosesNothingFromEitherSide) {
  for (const float alpha : kAlphas) {
    ExpectWhite(Glass(1.5f, alpha), 3e-3, true);
    ExpectWhite(Glass(1.5f, alpha), 3e-3, false);
  }
  ExpectWhite(Glass(2.417f, 0.3f), 3e-3, true);
  ExpectWhite(Glass(2.417f, 0.3f), 3e-3, false);
}

constexpr float kWavelengths[] = {kShortestWavelength, 450, 530, Dispersion::kYellow,
                                  kLongestWavelength};

/// A boundary between two media, as light of one wavelength or, for 0, of all meets it.
Bsdf BsdfBetween(const Material& material, const Medium& here, const Medium& beyond,
                 float wavelength) {
  SurfacePoint point;
  point.n_geometric = point.n_shading = kNormal;
  Bsdf bsdf;
  bsdf.frame = Frame::FromNormal(kNormal);
  bsdf.wavelength = wavelength;
  bsdf.medium_here = &here;
  bsdf.medium_beyond = &beyond;
  material.Evaluate(point, &bsdf);
  return bsdf;
}

/// Light of each wavelength finds glass that disperses white, ground and under a film or not, also
/// between two media.
void ExpectWhiteForEachWavelength(float alpha, const std::optional<FilmInput>& film) {
  const Medium glass{1.5f, {}, Dispersion::OfAbbeNumber(1.5f, 2)};
  const Medium oil{1.3f, {}, Dispersion::OfAbbeNumber(1.3f, 4)};
  const Medium media[] = {kAir, glass, oil};
  const DielectricMaterial material(glass, Roughness::OfAlpha(alpha), media, film);
  const Medium* const pairs[][2] = {{&kAir, &glass}, {&glass, &kAir}, {&glass, &oil}};
  for (const auto& [here, beyond] : pairs) {
    for (const float wavelength : kWavelengths) {
      SCOPED_TRACE(testing::Message() << alpha << ", " << here->ior << ", " << wavelength);
      ExpectWhite(BsdfBetween(material, *here, *beyond, wavelength), 4e-3);
    }
  }
}

// P4: each wavelength has the energies of its own index.
TEST(WhiteFurnace, GroundGlassThatDispersesLosesNothingOfAnyColour) {
  for (const float alpha : {0.1f, 0.5f, 1.0f}) ExpectWhiteForEachWavelength(alpha, std::nullopt);
}

// P4: and of its own reflectance, which a film makes another one for each.
TEST(WhiteFurnace, FilmsOnGroundGlassThatDispersesLoseNothingOfAnyColour) {
  ExpectWhiteForEachWavelength(0.5f, FilmInput(3, 150));
  ExpectWhiteForEachWavelength(1, FilmInput(1.5f, 150));
  ExpectWhiteForEachWavelength(1, FilmInput(2, 400));
}

// P4: media may have the same index for yellow light and others for the rest, which sees facets.
TEST(WhiteFurnace, GroundGlassInGlassThatDispersesOtherwiseIsRough) {
  const Medium glass{1.5f, {}, Dispersion::OfAbbeNumber(1.5f, 20)}, plain{1.5f, {}};
  const Medium media[] = {kAir, glass, plain};
  const DielectricMaterial material(glass, Roughness::OfAlpha(0.5f), media);
  const Medium* const pairs[][2] = {{&glass, &plain}, {&plain, &glass}};
  for (const auto& [here, beyond] : pairs) {
    for (const float wavelength : kWavelengths) {
      SCOPED_TRACE(testing::Message() << here->dispersion.IsNone() << ", " << wavelength);
      const Bsdf bsdf = BsdfBetween(material, *here, *beyond, wavelength);
      const bool is_yellow = wavelength == Dispersion::kYellow;
      EXPECT_EQ(IsDelta(bsdf.lobes[0].kind), is_yellow);
      ExpectWhite(bsdf, 4e-3);
    }
  }
}

// P4: a film reflects also between equal media, and on facets as these are turned.
TEST(WhiteFurnace, RoughFilmsBetweenEqualMediaAreRoughAndLoseNothing) {
  const Medium glass{1.5f, {}, Dispersion::OfAbbeNumber(1.5f, 20)}, plain{1.5f, {}};
  const Medium media[] = {kAir, glass, plain};
  const FilmInput film(3, 150);
  const Medium* const pairs[][2] = {
      {&kAir, &kAir}, {&glass, &glass}, {&glass, &plain}, {&plain, &glass}};
  const DielectricMaterial material({1, {}}, Roughness::OfAlpha(0.5f), media, film);
  for (const auto& [here, beyond] : pairs) {
    for (const float wavelength : {0.0f, 450.0f, Dispersion::kYellow}) {
      SCOPED_TRACE(testing::Message() << here->ior << ", " << wavelength);
      const Bsdf bsdf = BsdfBetween(material, *here, *beyond, wavelength);
      EXPECT_FALSE(IsDelta(bsdf.lobes[0].kind));
      ExpectWhite(bsdf, 4e-3);
      const Vec3 mirrored = DirectionAt(bsdf.frame, 30, 180);
      EXPECT_GT(Eval(bsdf, DirectionAt(bsdf.frame, 30, 0), mirrored)[1], 0.01f);
    }
  }
  ExpectWhite(material, 4e-3, true);
  ExpectWhite(material, 4e-3, false);
}

// P4: a film that absorbs nothing sends back or lets through what the base does not.
TEST(WhiteFurnace, ThinFilmsLoseNothing) {
  const FilmInput film(2.2f, 150);
  for (const float alpha : {0.0f, 0.1f, 0.5f, 1.0f}) {
    ExpectWhite(ConductorMaterial({0, 0, 0}, {3, 3, 3}, Roughness::OfAlpha(alpha), film), 2e-3);
    const DielectricMaterial glass({1.5f, {}}, Roughness::OfAlpha(alpha), {}, film);
    ExpectWhite(glass, 3e-3, true);
    ExpectWhite(glass, 3e-3, false);
  }
  ExpectWhite(ConductorMaterial({0, 0, 0}, {3, 3, 3}, {0.5f, 0.1f}, 30, film), 2e-3);
}

// P4
TEST(WhiteFurnace, WhitePlasticLosesNothing) {
  for (const float alpha : {0.0f, 0.01f, 0.1f, 0.25f, 0.5f, 1.0f}) {
    ExpectWhite(PlasticMaterial(Rgb{1, 1, 1}, 1.5f, Roughness::OfAlpha(alpha)), 2e-3);
  }
}

/// White, with a roughness whose square is `alpha`.
PrincipledMaterial::Inputs WhitePrincipled(float alpha) {
  PrincipledMaterial::Inputs inputs;
  inputs.base_color = Rgb{1, 1, 1};
  inputs.roughness = Roughness::OfAlpha(alpha);
  return inputs;
}

// P4
TEST(WhiteFurnace, PrincipledLosesNothingBetweenPlasticAndMetal) {
  for (const float alpha : kAlphas) {
    for (const float metallic : {0.0f, 0.3f, 1.0f}) {
      for (const float specular : {0.0f, 0.5f, 1.0f}) {
        SCOPED_TRACE(testing::Message() << alpha << ", metal " << metallic << ", " << specular);
        PrincipledMaterial::Inputs inputs = WhitePrincipled(alpha);
        inputs.metallic = metallic;
        inputs.specular = specular;
        ExpectWhite(PrincipledMaterial(inputs), 2e-3);
      }
    }
  }
}

// P4
TEST(WhiteFurnace, BrushedPrincipledLosesNothing) {
  for (const float metallic : {0.0f, 1.0f}) {
    PrincipledMaterial::Inputs inputs = WhitePrincipled(0.25f);
    inputs.metallic = metallic;
    inputs.anisotropy = 0.8f;
    inputs.rotation_degrees = 30;
    ExpectWhite(PrincipledMaterial(inputs), 2e-3);
  }
}

/// Says what is written in a number.
class DialTexture final : public Texture {
 public:
  explicit DialTexture(const float* value) : value_(value) {}
  Rgb Lookup(const SurfacePoint&) const override { return {*value_, *value_, *value_}; }

 private:
  const float* value_;
};

// P4: where textures say how rough and how brushed it is, also between the tables that it has.
TEST(WhiteFurnace, PrincipledBrushedByTexturesLosesNothing) {
  float roughness = 0, anisotropy = 0;
  for (const float metallic : {0.0f, 1.0f}) {
    for (const bool is_rough_textured : {false, true}) {
      PrincipledMaterial::Inputs inputs = WhitePrincipled(0.5f);
      inputs.metallic = metallic;
      inputs.anisotropy = NumberInput(std::make_shared<DialTexture>(&anisotropy));
      if (is_rough_textured) {
        inputs.roughness = Roughness::OfTexture(std::make_shared<DialTexture>(&roughness));
      }
      const PrincipledMaterial material(inputs);
      for (const float a : {0.0f, 0.28f, 0.65f, 0.97f, 1.0f}) {
        for (const float r : {0.22f, 0.5f, 0.68f, 0.86f, 1.0f}) {
          if (!is_rough_textured && r > 0.22f) break;
          for (const double azimuth : {0.0, 40.0, 90.0}) {
            SCOPED_TRACE(testing::Message() << "metal " << metallic << ", roughness " << r
                                            << (is_rough_textured ? " textured" : "")
                                            << ", anisotropy " << a << ", azimuth " << azimuth);
            roughness = r;
            anisotropy = a;
            ExpectWhite(BsdfOf(material, kNormal), 1e-2, azimuth);
          }
        }
      }
    }
  }
}

// P4
TEST(WhiteFurnace, TransmissivePrincipledLosesNothingFromEitherSide) {
  for (const float transmission : {0.4f, 1.0f}) {
    PrincipledMaterial::Inputs inputs = WhitePrincipled(0.25f);
    inputs.transmission = transmission;
    inputs.metallic = 0.2f;
    ExpectWhite(PrincipledMaterial(inputs), 3e-3, true);
    ExpectWhite(PrincipledMaterial(inputs), 3e-3, false);
  }
}

// P4
TEST(WhiteFurnace, RetroreflectorLosesNothing) {
  for (const float alpha : kAlphas) {
    ExpectWhite(RetroreflectiveMaterial(Rgb{1, 1, 1}, Rgb{1, 1, 1}, 1, Roughness::OfAlpha(alpha)),
                2e-3);
  }
}

/// The least of what a material gives back at any angle.
double LeastAlbedo(const Material& material) {
  UniformNumbers random(17);
  const Bsdf bsdf = BsdfOf(material, kNormal);
  double least = 1;
  for (const double degrees : kIncidences) {
    const Albedo albedo = AlbedoOf(bsdf, DirectionAt(bsdf.frame, degrees), 20000, &random);
    for (const double mean : albedo.mean) least = std::min(least, mean);
    EXPECT_LE(albedo.mean[0], 1 + 2e-3 + kLargestDeviate * albedo.error[0]) << degrees;
  }
  return least;
}

// What is mirrored below a coat or fuzz is scaled by the lesser of what these let through: a
// part of it is lost, and none of what a polished metal mirrors.
TEST(Principled, LosesLittleBelowACoatAndMoreBelowFuzz) {
  PrincipledMaterial::Inputs coated = WhitePrincipled(0.25f);
  coated.clearcoat = 1;
  EXPECT_GT(LeastAlbedo(PrincipledMaterial(coated)), 0.97);

  PrincipledMaterial::Inputs metal = WhitePrincipled(0);
  metal.metallic = metal.clearcoat = 1;
  EXPECT_GT(LeastAlbedo(PrincipledMaterial(metal)), 0.99);

  PrincipledMaterial::Inputs fuzzy = WhitePrincipled(0.25f);
  fuzzy.sheen = 1;
  EXPECT_GT(LeastAlbedo(PrincipledMaterial(fuzzy)), 0.85);
}

// P5: where textures say how rough and how brushed it is, the tables are those of all roughnesses.
TEST(Principled, OfTexturesMakesNoLightAndLosesLittle) {
  const auto texture = [](float value) {
    return std::make_shared<ConstantTexture>(Rgb{value, value, value});
  };
  for (const float roughness : {0.37f, 0.83f}) {
    PrincipledMaterial::Inputs inputs = WhitePrincipled(0);
    inputs.roughness = Roughness::OfTexture(texture(roughness));
    inputs.clearcoat = 0.7f;
    inputs.clearcoat_roughness = Roughness::OfTexture(texture(0.35f));
    EXPECT_GT(LeastAlbedo(PrincipledMaterial(inputs)), 0.97) << roughness;
    inputs.anisotropy = NumberInput(texture(0.7f));
    inputs.metallic = 0.5f;
    EXPECT_GT(LeastAlbedo(PrincipledMaterial(inputs)), 0.95) << roughness;
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
}  // namespace candela
