// What `principled` is made of, and that `retroreflective` sends light back.

#include "materials/principled.h"

#include <gtest/gtest.h>

#include <cmath>

#include "materials/conductor.h"
#include "materials/dielectric.h"
#include "materials/energy_store.h"
#include "materials/retroreflective.h"
#include "math/elementary.h"
#include "tests/materials/scatter.h"

namespace candela {
namespace {

using test::BsdfOf;
using test::DirectionAt;
using test::UniformNumbers;

const Vec3 kNormal{0, 0, 1};
constexpr auto kPiF = static_cast<float>(kPi);

PrincipledMaterial::Inputs Coloured(Rgb color, float alpha) {
  PrincipledMaterial::Inputs inputs;
  inputs.base_color = color;
  inputs.roughness = Roughness::OfAlpha(alpha);
  return inputs;
}

// Those that are alike have their tables in common: brushed by a texture they take a second.
TEST(Principled, OfTheSameKindIsTabulatedOnce) {
  EnergyStore energies;
  const auto layers = [&](float ior, float alpha) {
    PrincipledMaterial::Inputs inputs = Coloured({1, 1, 1}, alpha);
    inputs.ior = ior;
    inputs.anisotropy = 0.5f;
    const PrincipledMaterial material(inputs, {}, &energies);
    return *BsdfOf(material, kNormal).lobes[0].principled.layers;
  };
  const PrincipledLayers first = layers(1.5f, 0.25f), same = layers(1.5f, 0.25f);
  EXPECT_EQ(same.metal, first.metal);
  EXPECT_EQ(same.dielectric, first.dielectric);
  const PrincipledLayers denser = layers(1.6f, 0.25f), rougher = layers(1.5f, 0.5f);
  EXPECT_EQ(denser.metal, first.metal);
  EXPECT_NE(denser.dielectric, first.dielectric);
  EXPECT_NE(rougher.metal, first.metal);
}

/// Pairs of directions at many angles.
template <class Check>
void ForEachPair(const Frame& frame, const Check& check) {
  for (const double out : {5.0, 40.0, 75.0}) {
    for (const double in : {10.0, 50.0, 80.0}) {
      for (const double azimuth : {0.0, 70.0, 200.0}) {
        check(DirectionAt(frame, out), DirectionAt(frame, in, azimuth));
      }
    }
  }
}

TEST(Principled, WithoutSpecularIsDiffuse) {
  PrincipledMaterial::Inputs inputs = Coloured({0.8f, 0.4f, 0.2f}, 0.3f);
  inputs.specular = 0;
  const PrincipledMaterial material(inputs);
  const Bsdf bsdf = BsdfOf(material, kNormal);
  ForEachPair(bsdf.frame, [&](Vec3 wo, Vec3 wi) {
    const Spectrum value = Eval(bsdf, wo, wi);
    EXPECT_NEAR(value[0] * kPiF, 0.8f, 1e-6f);
    EXPECT_NEAR(value[2] * kPiF, 0.2f, 1e-6f);
  });
}

TEST(Principled, OfWhiteMetalIsAWhiteConductor) {
  PrincipledMaterial::Inputs inputs = Coloured({1, 1, 1}, 0.3f);
  inputs.metallic = 1;
  const PrincipledMaterial material(inputs);
  const Bsdf bsdf = BsdfOf(material, kNormal);
  const ConductorMaterial conductor(Rgb{0, 0, 0}, Rgb{3, 3, 3}, Roughness::OfAlpha(0.3f));
  const Bsdf metal = BsdfOf(conductor, kNormal);
  ForEachPair(bsdf.frame, [&](Vec3 wo, Vec3 wi) {
    const float expected = Eval(metal, wo, wi)[0];
    EXPECT_NEAR(Eval(bsdf, wo, wi)[0], expected, 5e-5f * expected);
    EXPECT_NEAR(Pdf(bsdf, wo, wi), Pdf(metal, wo, wi), 1e-4f * Pdf(metal, wo, wi));
  });
}

// Schlick: the colour head-on, white at a flat angle.
TEST(Principled, OfMetalHasItsColourHeadOn) {
  PrincipledMaterial::Inputs inputs = Coloured({0.9f, 0.5f, 0.1f}, 1e-3f);
  inputs.metallic = 1;
  const PrincipledMaterial material(inputs);
  const Bsdf bsdf = BsdfOf(material, kNormal);
  const Spectrum head_on = Eval(bsdf, kNormal, kNormal);
  EXPECT_NEAR(head_on[1] / head_on[0], 0.5f / 0.9f, 1e-4f);
  EXPECT_NEAR(head_on[2] / head_on[0], 0.1f / 0.9f, 1e-4f);
  const Spectrum flat =
      Eval(bsdf, DirectionAt(bsdf.frame, 89, 0), DirectionAt(bsdf.frame, 89, 180));
  EXPECT_GT(flat[2] / flat[0], 0.9f);
}

TEST(Principled, OfGlassIsADielectric) {
  PrincipledMaterial::Inputs inputs = Coloured({1, 1, 1}, 0.2f);
  inputs.transmission = 1;
  const PrincipledMaterial material(inputs);
  ASSERT_NE(material.Body(), nullptr);
  EXPECT_EQ(material.Body()->ior, 1.5f);
  const DielectricMaterial glass({1.5f, {}}, Roughness::OfAlpha(0.2f));
  for (const bool is_outside : {true, false}) {
    const Bsdf a = BsdfOf(material, kNormal, is_outside), b = BsdfOf(glass, kNormal, is_outside);
    UniformNumbers random(3);
    for (int i = 0; i < 100; ++i) {
      const Vec2 u = random.NextPair();
      const BsdfSample from_a = Sample(a, DirectionAt(a.frame, 50), u);
      const BsdfSample from_b = Sample(b, DirectionAt(b.frame, 50), u);
      EXPECT_EQ(from_a.wi, from_b.wi);
      EXPECT_EQ(from_a.weight.ToRgb(), from_b.weight.ToRgb());
    }
  }
}

TEST(Principled, TintsWhatGoesThroughGlassAndNotWhatIsMirrored) {
  for (const float alpha : {0.0f, 0.1f}) {
    PrincipledMaterial::Inputs inputs = Coloured({0.25f, 1, 0.64f}, alpha);
    inputs.transmission = 1;
    const PrincipledMaterial material(inputs);
    const Bsdf bsdf = BsdfOf(material, kNormal);
    UniformNumbers random(3);
    int through = 0, mirrored = 0;
    for (int i = 0; i < 1000; ++i) {
      const BsdfSample sample = Sample(bsdf, DirectionAt(bsdf.frame, 60), random.NextPair());
      if (!(sample.pdf > 0)) continue;
      ++(sample.is_transmission ? through : mirrored);
      EXPECT_NEAR(sample.weight[0] / sample.weight[1], sample.is_transmission ? 0.5f : 1, 1e-5f);
      EXPECT_NEAR(sample.weight[2] / sample.weight[1], sample.is_transmission ? 0.8f : 1, 1e-5f);
    }
    EXPECT_GT(through, 100);
    EXPECT_GT(mirrored, 10);
  }
}

// Two lobes: the wide one of the base and, on top of it, the narrow one of the coat.
TEST(Principled, ShowsTheHighlightOfItsCoat) {
  PrincipledMaterial::Inputs inputs = Coloured({0, 0, 0}, 0.5f);
  const PrincipledMaterial of_bare(inputs);
  const Bsdf bare = BsdfOf(of_bare, kNormal);
  inputs.clearcoat = 1;
  inputs.clearcoat_roughness = Roughness::OfAlpha(0.01f);
  const PrincipledMaterial of_coated(inputs);
  const Bsdf coated = BsdfOf(of_coated, kNormal);
  const Vec3 wo = DirectionAt(bare.frame, 30, 0), mirrored = DirectionAt(bare.frame, 30, 180);
  EXPECT_GT(Eval(coated, wo, mirrored)[0], 50 * Eval(bare, wo, mirrored)[0]);
  const Vec3 beside = DirectionAt(bare.frame, 10, 180);
  EXPECT_LT(Eval(coated, wo, beside)[0], Eval(bare, wo, beside)[0]);
  EXPECT_GT(Eval(coated, wo, beside)[0], 0.9f * Eval(bare, wo, beside)[0]);
}

TEST(Principled, HasFuzzOfItsHueAtFlatAngles) {
  PrincipledMaterial::Inputs inputs = Coloured({0.4f, 0.2f, 0}, 1);
  inputs.specular = 0;
  const PrincipledMaterial of_bare(inputs);
  const Bsdf bare = BsdfOf(of_bare, kNormal);
  inputs.sheen = 1;
  inputs.sheen_tint = 1;
  const PrincipledMaterial of_fuzzy(inputs);
  const Bsdf fuzzy = BsdfOf(of_fuzzy, kNormal);
  const auto ratio = [&](double degrees) {
    const Vec3 wo = DirectionAt(bare.frame, degrees, 0), wi = DirectionAt(bare.frame, 70, 150);
    return Eval(fuzzy, wo, wi)[0] / Eval(bare, wo, wi)[0];
  };
  EXPECT_GT(ratio(80), 1.5f);
  EXPECT_LT(ratio(0), 1.2f);
  const Vec3 flat = DirectionAt(bare.frame, 85, 0);
  const Spectrum value = Eval(fuzzy, flat, flat);
  EXPECT_NEAR(value[1] / value[0], 0.5f, 1e-5f);
  EXPECT_EQ(value[2], 0);
}

// The highlight is drawn out along the first axis, and turns with it.
TEST(Principled, IsBrushedAlongItsDirection) {
  PrincipledMaterial::Inputs inputs = Coloured({1, 1, 1}, 0.2f);
  inputs.metallic = 1;
  inputs.anisotropy = 0.9f;
  for (const float rotation : {0.0f, 30.0f}) {
    inputs.rotation_degrees = rotation;
    const PrincipledMaterial material(inputs);
    EXPECT_TRUE(material.NeedsTextureCoordinates());
    SurfacePoint point;
    point.n_shading = kNormal;
    point.dpdu = {1, 0, 0};
    Bsdf bsdf;
    bsdf.frame = Frame::FromNormal(kNormal);
    material.Evaluate(point, &bsdf);
    const auto turn = static_cast<double>(rotation);
    const auto at = [&](double azimuth) {
      const Vec3 wi = ToFloat({SinDegrees(40) * CosDegrees(azimuth),
                               SinDegrees(40) * SinDegrees(azimuth), CosDegrees(40)});
      return Eval(bsdf, kNormal, wi)[0];
    };
    EXPECT_GT(at(turn), 10 * at(turn + 90));
    EXPECT_NEAR(at(turn), at(turn + 180), 1e-3f * at(turn));
  }
}

TEST(Principled, WithNothingReflectsNothing) {
  PrincipledMaterial::Inputs inputs = Coloured({0, 0, 0}, 0.2f);
  inputs.specular = 0;
  const PrincipledMaterial material(inputs);
  const Bsdf bsdf = BsdfOf(material, kNormal);
  EXPECT_TRUE(Eval(bsdf, kNormal, kNormal).IsBlack());
  EXPECT_EQ(Sample(bsdf, kNormal, {0.3f, 0.6f}).pdf, 0);
  EXPECT_EQ(Pdf(bsdf, kNormal, kNormal), 0);
}

TEST(Retroreflective, SendsLightBackToWhereItCameFrom) {
  const RetroreflectiveMaterial vest(Rgb{0.5f, 0.5f, 0.5f}, Rgb{1, 1, 1}, 0.5f,
                                     Roughness::OfAlpha(0.04f));
  const Bsdf bsdf = BsdfOf(vest, kNormal);
  for (const double degrees : {20.0, 40.0, 65.0}) {
    const Vec3 wo = DirectionAt(bsdf.frame, degrees);
    const Vec3 mirrored = DirectionAt(bsdf.frame, degrees, 220);
    EXPECT_GT(Eval(bsdf, wo, wo)[0], 20.0f) << degrees;
    EXPECT_NEAR(Eval(bsdf, wo, mirrored)[0] * kPiF, 0.25f, 0.05f) << degrees;
    UniformNumbers random(3);
    int back = 0;
    for (int i = 0; i < 1000; ++i) {
      back += Dot(Sample(bsdf, wo, random.NextPair()).wi, wo) > 0.9f;
    }
    EXPECT_GT(back, 600) << degrees;
  }
}

/// The value for two directions that the surface z = 0 sees, or for those mirrored in it.
Spectrum ValueOn(const Material& material, Vec3 wo, Vec3 wi, bool is_outside) {
  SurfacePoint point;
  point.n_geometric = point.n_shading = {0, 0, 1};
  point.dpdu = {1, 0, 0};
  point.dpdv = {0, 1, 0};
  const float side = is_outside ? 1 : -1;
  Bsdf bsdf;
  bsdf.frame = Frame::FromNormal({0, 0, side});
  material.Evaluate(point, &bsdf);
  return Eval(bsdf, {wo.x, wo.y, wo.z * side}, {wi.x, wi.y, wi.z * side});
}

// A thin sheet is brushed in the same direction on both of its sides.
TEST(BrushedSurface, IsTurnedTheSameWayOnBothSides) {
  PrincipledMaterial::Inputs inputs;
  inputs.metallic = 1;
  inputs.anisotropy = 0.9f;
  inputs.rotation_degrees = 30;
  const PrincipledMaterial principled(inputs);
  const ConductorMaterial conductor({1, 1, 1}, {3, 3, 3}, {0.5f, 0.1f}, 30);
  const Vec3 wo = Normalize(Vec3{0.1f, 0.2f, 1}), wi = Normalize(Vec3{0.5f, 0.1f, 1});
  for (const Material* material :
       {static_cast<const Material*>(&principled), static_cast<const Material*>(&conductor)}) {
    const float outside = ValueOn(*material, wo, wi, true)[0];
    EXPECT_GT(
        std::abs(outside - ValueOn(*material, {wo.x, -wo.y, wo.z}, {wi.x, -wi.y, wi.z}, true)[0]),
        0.1f * outside)
        << "the direction of the brushing does not show";
    EXPECT_NEAR(ValueOn(*material, wo, wi, false)[0], outside, 1e-4f * outside);
  }
}

}  // namespace
}  // namespace candela
