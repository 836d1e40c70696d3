#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cctype>
#include <sstream>
#include <string>

#include "materials/diffuse.h"
#include "materials/phong.h"
#include "materials/registry.h"
#include "math/elementary.h"

namespace candela {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// A material of the given type from "name number number ... name number ...".
std::unique_ptr<Material> Create(const std::string& type, const std::string& text,
                                 Diagnostics* diagnostics) {
  TypedSpec spec{type, {}, {}};
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    if (std::isalpha(static_cast<unsigned char>(word[0]))) {
      spec.params.params.push_back({word, {}, {}});
    } else {
      spec.params.params.back().words.push_back({word, {}});
    }
  }
  return CreateMaterial(spec, diagnostics);
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
  const PhongTerms terms = DiffuseMaterial({0.5f, 0.25f, 1}).Phong({});
  EXPECT_EQ(terms.diffuse, (Rgb{0.5f, 0.25f, 1}));
  EXPECT_EQ(terms.ambient, (Rgb{0.5f, 0.25f, 1}));
  EXPECT_EQ(terms.specular, (Rgb{0, 0, 0}));
}

TEST(Diffuse, RefusesWhatIsNoAlbedo) {
  EXPECT_THAT(ProblemsOf("diffuse", "albedo 0 0.5 1"), IsEmpty());
  EXPECT_THAT(ProblemsOf("diffuse", "albedo 0 0.5 1.1"), ElementsAre(HasSubstr("from 0 to 1")));
  EXPECT_THAT(ProblemsOf("diffuse", "albedo -0.1 0 0"), ElementsAre(HasSubstr("from 0 to 1")));
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
  DiffuseMaterial({0.5f, 0.25f, 1}).Evaluate({}, &bsdf);
  const Rgb value = Eval(bsdf, {0, 0, 1}, {0.6f, 0, 0.8f}).ToRgb();
  EXPECT_FLOAT_EQ(value.x, static_cast<float>(0.5 / kPi));
  EXPECT_FLOAT_EQ(value.y, static_cast<float>(0.25 / kPi));
  EXPECT_FLOAT_EQ(value.z, static_cast<float>(1 / kPi));
  EXPECT_TRUE(Eval(bsdf, {0, 0, 1}, {0.6f, 0, -0.8f}).IsBlack());
  EXPECT_TRUE(Eval(bsdf, {0, 0, -1}, {0.6f, 0, 0.8f}).IsBlack());
}

}  // namespace
}  // namespace candela
