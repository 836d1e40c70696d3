#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cctype>
#include <sstream>
#include <string>

#include "materials/dielectric.h"
#include "materials/diffuse.h"
#include "materials/mirror.h"
#include "materials/phong.h"
#include "materials/registry.h"
#include "math/elementary.h"
#include "tests/materials/scatter.h"
#include "tests/support/compile_text.h"

namespace candela {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// A material of the given type from "name word number ... name number ...".
std::unique_ptr<Material> Create(const std::string& type, const std::string& text,
                                 Diagnostics* diagnostics) {
  TypedSpec spec{type, {}, {}};
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    const bool is_due = !spec.params.params.empty() && spec.params.params.back().words.empty();
    if (!is_due && std::isalpha(static_cast<unsigned char>(word[0]))) {
      spec.params.params.push_back({word, {}, {}});
    } else {
      spec.params.params.back().words.push_back({word, {}});
    }
  }
  static const DiffuseMaterial kWhite(Rgb{1, 1, 1});
  static const MirrorMaterial kMirror(Rgb{1, 1, 1});
  MaterialContext context;
  context.diagnostics = diagnostics;
  context.find_material = [&](std::string_view name, const SourceLocation&) -> const Material* {
    if (name == "white") return &kWhite;
    return name == "mirror" ? &kMirror : nullptr;
  };
  return CreateMaterial(spec, context);
}

PhongTerms TermsOf(const std::string& text) {
  Diagnostics diagnostics;
  const auto material = Create("phong", text, &diagnostics);
  EXPECT_THAT(diagnostics.Lines(), IsEmpty());
  return material->Phong({});
}

std::vector<std::string> ProblemsOf(const std::string& type, const std::string& text) {
  Diagnostics diagnostics;
  Create(type, text, &diagnostics);
  return diagnostics.Lines();
}

TEST(Phong, ItsDiffuseColourTakesAmbientLightToo) {
  const PhongTerms terms = TermsOf("diffuse 0.5 0.25 1 specular 1 0 0 shininess 20");
  EXPECT_EQ(terms.diffuse, (Rgb{0.5f, 0.25f, 1}));
  EXPECT_EQ(terms.ambient, (Rgb{0.5f, 0.25f, 1}));
  EXPECT_EQ(terms.specular, (Rgb{1, 0, 0}));
  EXPECT_EQ(terms.shininess, 20.0f);
}

TEST(Phong, WithoutDiffuseItIsWhiteToLightsAndTakesNoAmbientLight) {
  const PhongTerms terms = TermsOf("specular 0 0 1");
  EXPECT_EQ(terms.diffuse, (Rgb{1, 1, 1}));
  EXPECT_EQ(terms.ambient, (Rgb{0, 0, 0}));
  EXPECT_EQ(terms.shininess, 0.0f);
}

TEST(Phong, IsPhysicalWithoutHighlightAndWithAnAlbedo) {
  const auto is_physical = [](Rgb diffuse, Rgb specular) {
    return PhongMaterial({diffuse, diffuse, specular, 1}).IsPhysical();
  };
  EXPECT_TRUE(is_physical({1, 0.5f, 0}, {0, 0, 0}));
  EXPECT_FALSE(is_physical({1, 0.5f, 0}, {0, 0.1f, 0}));
  EXPECT_FALSE(is_physical({1.1f, 0.5f, 0}, {0, 0, 0}));
  EXPECT_FALSE(is_physical({1, 0.5f, -0.1f}, {0, 0, 0}));
}

TEST(Diffuse, IsForWhittedTheSamePhongSurface) {
  const PhongTerms terms = DiffuseMaterial(Rgb{0.5f, 0.25f, 1}).Phong({});
  EXPECT_EQ(terms.diffuse, (Rgb{0.5f, 0.25f, 1}));
  EXPECT_EQ(terms.ambient, (Rgb{0.5f, 0.25f, 1}));
  EXPECT_EQ(terms.specular, (Rgb{0, 0, 0}));
}

TEST(Diffuse, RefusesWhatIsNoAlbedo) {
  EXPECT_THAT(ProblemsOf("diffuse", "albedo 0 0.5 1"), IsEmpty());
  EXPECT_THAT(ProblemsOf("diffuse", "albedo 0 0.5 1.1"), ElementsAre(HasSubstr("from 0 to 1")));
  EXPECT_THAT(ProblemsOf("diffuse", "albedo -0.1 0 0"), ElementsAre(HasSubstr("from 0 to 1")));
}

TEST(NormalisedPhong, IsPhysicalWhereItIsNoBrighterThanItsLight) {
  EXPECT_THAT(ProblemsOf("phong", "diffuse 0.5 0.5 0.5 specular 0.5 0 0.25 normalised true"),
              IsEmpty());
  EXPECT_THAT(ProblemsOf("phong", "diffuse 0.5 0.5 0.5 specular 0.6 0 0 normalised true"),
              ElementsAre(HasSubstr("together at most 1")));
  EXPECT_THAT(ProblemsOf("phong", "diffuse 0.5 0.5 0.5 shininess -1 normalised true"),
              ElementsAre(HasSubstr("'shininess' that is not negative")));
  EXPECT_THAT(ProblemsOf("phong", "diffuse 1 1 1 normalised yes"),
              ElementsAre(HasSubstr("'normalised' expects 'true' or 'false', found 'yes'")));
}

TEST(Conductor, IsANamedMetalOrHasEtaAndK) {
  EXPECT_THAT(ProblemsOf("conductor", "metal brass"), IsEmpty());
  EXPECT_THAT(ProblemsOf("conductor", "eta 1 1 1 k 2 2 2"), IsEmpty());
  EXPECT_THAT(ProblemsOf("conductor", "eta 1 1 1"),
              ElementsAre(HasSubstr("needs 'metal', or 'eta' and 'k'")));
  EXPECT_THAT(ProblemsOf("conductor", "metal bras"),
              ElementsAre(HasSubstr("there is no metal 'bras' (did you mean 'brass'?); known: ")));
  EXPECT_THAT(ProblemsOf("conductor", "metal gold k 1 1 1"),
              ElementsAre(HasSubstr("'k' is not used")));
}

TEST(Conductor, IsRoughInOneWayOnly) {
  EXPECT_THAT(ProblemsOf("conductor", "metal gold alpha_x 0.1 alpha_y 0.2 rotation 30"), IsEmpty());
  EXPECT_THAT(ProblemsOf("conductor", "metal gold roughness 0.1 alpha_x 0.1 alpha_y 0.2"),
              ElementsAre(HasSubstr("not by both")));
  EXPECT_THAT(ProblemsOf("conductor", "metal gold alpha_x 0.1"),
              ElementsAre(HasSubstr("given together")));
  EXPECT_THAT(ProblemsOf("conductor", "metal gold roughness 1.5"),
              ElementsAre(HasSubstr("'roughness' expects a number from 0 to 1, found '1.5'")));
}

TEST(Dielectric, HasAnIndexByNumberOrName) {
  EXPECT_THAT(ProblemsOf("dielectric", "ior water"), IsEmpty());
  EXPECT_THAT(ProblemsOf("dielectric", "ior 1.7 absorption 1 2 3"), IsEmpty());
  EXPECT_THAT(ProblemsOf("dielectric", "ior 0"),
              ElementsAre(HasSubstr("'ior' expects a positive number or one of ")));
  EXPECT_THAT(ProblemsOf("dielectric", "ior wood"), ElementsAre(HasSubstr("found 'wood'")));
}

TEST(Dielectric, OnlyAPaneHasAThickness) {
  EXPECT_THAT(ProblemsOf("dielectric", "thin true thickness 0.1"), IsEmpty());
  EXPECT_THAT(ProblemsOf("dielectric", "thickness 0.1"), ElementsAre(HasSubstr("is not used by")));
}

// Head-on a ray goes straight on, with 4 percent less; in the denser medium it is n^2 brighter, so
// on the way in the weight is smaller by that.
TEST(Dielectric, CarriesRadianceIntoGlass) {
  Bsdf bsdf;
  SurfacePoint point;
  point.n_shading = {0, 0, 1};
  DielectricMaterial({1.5f, {}}, Roughness()).Evaluate(point, &bsdf);
  const BsdfSample sample = Sample(bsdf, {0, 0, 1}, {0.5f, 0.5f});
  EXPECT_TRUE(sample.is_delta);
  EXPECT_TRUE(sample.is_transmission);
  EXPECT_EQ(sample.wi, (Vec3{0, 0, -1}));
  EXPECT_EQ(sample.eta, 1.5f);
  EXPECT_FLOAT_EQ(sample.pdf, 0.96f);
  EXPECT_FLOAT_EQ(sample.weight[0] * sample.pdf, 0.96f / 2.25f);
}

TEST(Plastic, HasACoatThatIsDenserThanAir) {
  EXPECT_THAT(ProblemsOf("plastic", "albedo 1 0 0 ior 1.4 roughness 0.1"), IsEmpty());
  EXPECT_THAT(ProblemsOf("plastic", "ior 0.9"), ElementsAre(HasSubstr("above 1")));
}

TEST(Bsdf, DrawsItsLobesByTheirPicks) {
  Bsdf bsdf;
  bsdf.Add({LobeKind::kMirror, 1, Spectrum(Rgb{1, 1, 1})});
  bsdf.Add({LobeKind::kLambert, 3, Spectrum(Rgb{0.5f, 0.5f, 0.5f})});
  const Vec3 wo = {0.6f, 0, 0.8f};
  const BsdfSample mirrored = Sample(bsdf, wo, {0.2f, 0.5f});
  EXPECT_TRUE(mirrored.is_delta);
  EXPECT_EQ(mirrored.wi, (Vec3{-0.6f, 0, 0.8f}));
  EXPECT_EQ(mirrored.pdf, 0.25f);
  EXPECT_EQ(mirrored.weight[0], 4.0f);
  const BsdfSample scattered = Sample(bsdf, wo, {0.3f, 0.5f});
  EXPECT_FALSE(scattered.is_delta);
  EXPECT_EQ(scattered.pdf, Pdf(bsdf, wo, scattered.wi));
  EXPECT_TRUE(bsdf.HasSmoothPart());
}

TEST(Bsdf, OfAMirrorHasNoSmoothPart) {
  Bsdf bsdf;
  bsdf.Add({LobeKind::kMirror, 1, Spectrum(Rgb{1, 1, 1})});
  EXPECT_FALSE(bsdf.HasSmoothPart());
  EXPECT_TRUE(Eval(bsdf, {0, 0, 1}, {0, 0, 1}).IsBlack());
  EXPECT_EQ(Pdf(bsdf, {0, 0, 1}, {0, 0, 1}), 0.0f);
}

// A quarter of the surface is a mirror: so much of the light goes there, and of the samples.
TEST(Mix, GivesEachPartItsShare) {
  Diagnostics diagnostics;
  const auto mix = Create("mix", "first white second mirror amount 0.25", &diagnostics);
  ASSERT_THAT(diagnostics.Lines(), IsEmpty());
  Bsdf bsdf;
  mix->Evaluate({}, &bsdf);
  const Vec3 wo = {0.6f, 0, 0.8f}, wi = {0, 0.6f, 0.8f};
  EXPECT_FLOAT_EQ(Eval(bsdf, wo, wi)[0], static_cast<float>(0.75 / kPi));
  EXPECT_FLOAT_EQ(Pdf(bsdf, wo, wi), static_cast<float>(0.75 * 0.8 / kPi));
  const BsdfSample mirrored = Sample(bsdf, wo, {0.8f, 0.5f});
  EXPECT_TRUE(mirrored.is_delta);
  EXPECT_FLOAT_EQ(mirrored.pdf, 0.25f);
  EXPECT_FLOAT_EQ(mirrored.weight[1], 1);
  EXPECT_FLOAT_EQ(Sample(bsdf, wo, {0.3f, 0.5f}).weight[2], 1);
  const PhongTerms terms = mix->Phong({});
  EXPECT_EQ(terms.diffuse, (Rgb{0.75f, 0.75f, 0.75f}));
  EXPECT_EQ(terms.specular, (Rgb{0.25f, 0.25f, 0.25f}));
}

TEST(Mix, NeedsBothParts) {
  EXPECT_THAT(ProblemsOf("mix", "first white"), ElementsAre(HasSubstr("'mix' needs 'second'")));
  EXPECT_THAT(ProblemsOf("mix", "first white second mirror amount 2"),
              ElementsAre(HasSubstr("'amount' expects a number from 0 to 1")));
}

// Light goes straight through the holes.
TEST(Mask, LetsLightThroughItsHoles) {
  Diagnostics diagnostics;
  const auto mask = Create("mask", "material white opacity 0.25", &diagnostics);
  ASSERT_THAT(diagnostics.Lines(), IsEmpty());
  Bsdf bsdf;
  mask->Evaluate({}, &bsdf);
  const Vec3 wo = {0.6f, 0, 0.8f};
  const BsdfSample through = Sample(bsdf, wo, {0.8f, 0.5f});
  EXPECT_TRUE(through.is_delta);
  EXPECT_TRUE(through.is_transmission);
  EXPECT_EQ(through.wi, -wo);
  EXPECT_FLOAT_EQ(through.pdf, 0.75f);
  EXPECT_FLOAT_EQ(through.weight[0], 1);
  EXPECT_EQ(through.eta, 1);
  EXPECT_FLOAT_EQ(Eval(bsdf, wo, {0, 0, 1})[0], static_cast<float>(0.25 / kPi));
}

TEST(Mask, OfFullOpacityIsTheMaterial) {
  Diagnostics diagnostics;
  Bsdf bsdf;
  Create("mask", "material mirror", &diagnostics)->Evaluate({}, &bsdf);
  EXPECT_EQ(bsdf.count, 1);
  EXPECT_FALSE(bsdf.HasSmoothPart());
}

TEST(Bsdf, OfAnEmptyListIsBlack) {
  const Bsdf bsdf;
  EXPECT_TRUE(Eval(bsdf, {0, 0, 1}, {0, 0, 1}).IsBlack());
  EXPECT_EQ(Pdf(bsdf, {0, 0, 1}, {0, 0, 1}), 0.0f);
  EXPECT_EQ(Sample(bsdf, {0, 0, 1}, {0.5f, 0.5f}).pdf, 0.0f);
}

// rho / pi in all directions of the upper side; nothing below.
TEST(Bsdf, LambertIsTheAlbedoOverPi) {
  Bsdf bsdf;
  DiffuseMaterial(Rgb{0.5f, 0.25f, 1}).Evaluate({}, &bsdf);
  const Rgb value = Eval(bsdf, {0, 0, 1}, {0.6f, 0, 0.8f}).ToRgb();
  EXPECT_FLOAT_EQ(value.x, static_cast<float>(0.5 / kPi));
  EXPECT_FLOAT_EQ(value.y, static_cast<float>(0.25 / kPi));
  EXPECT_FLOAT_EQ(value.z, static_cast<float>(1 / kPi));
  EXPECT_TRUE(Eval(bsdf, {0, 0, 1}, {0.6f, 0, -0.8f}).IsBlack());
  EXPECT_TRUE(Eval(bsdf, {0, 0, -1}, {0.6f, 0, 0.8f}).IsBlack());
}

// Tables for all roughnesses take their time: glass of one index has the same, whatever texture
// says how rough it is, and glass of another index has its own.
TEST(RoughGlass, OfOneIndexSharesItsTables) {
  const auto scene = testing_support::CompileText(
      "Camera { center 0 0 5 direction 0 0 -1 up 0 1 0 fov 30 }\n"
      "Textures { Texture { name a type noise } Texture { name b type marble } }\n"
      "Materials { Material { type dielectric roughness texture a }\n"
      "  Material { type dielectric roughness texture b absorption 1 2 3 }\n"
      "  Material { type principled transmission 1 roughness texture b }\n"
      "  Material { type dielectric roughness texture a ior 1.6 } }\n"
      "Scene { Component<Object> { type sphere radius 1 } Component<Material> { index 0 } }");
  const EnergyTable *here[4], *beyond[4];
  for (size_t i = 0; i < 4; ++i) {
    const Bsdf bsdf = test::BsdfOf(*scene->materials()[i], {0, 0, 1});
    ASSERT_EQ(bsdf.lobes[0].kind, LobeKind::kDielectric);
    here[i] = bsdf.lobes[0].dielectric.energy_here;
    beyond[i] = bsdf.lobes[0].dielectric.energy_beyond;
  }
  EXPECT_EQ(here[0], here[1]);
  EXPECT_EQ(here[0], here[2]);
  EXPECT_EQ(beyond[0], beyond[1]);
  EXPECT_NE(here[0], beyond[0]);
  EXPECT_NE(here[0], here[3]);
}

}  // namespace
}  // namespace candela
