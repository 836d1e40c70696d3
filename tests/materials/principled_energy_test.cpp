// What principled surfaces give back of the light they get.

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

#include "materials/principled.h"
#include "tests/materials/white_furnace.h"
#include "textures/constant_texture.h"

namespace candela::test {
namespace {

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
      for (const float a : {0.0f, 0.28f, 0.97f, 1.0f}) {
        for (const float r : {0.22f, 0.68f, 1.0f}) {
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

}  // namespace
}  // namespace candela::test
