#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/textures/make_texture.h"
#include "textures/constant_texture.h"
#include "textures/texture_input.h"

namespace candela {
namespace {

using test::At;
using testing::IsEmpty;

std::shared_ptr<const Texture> Make(const std::string& type, const std::string& text) {
  Diagnostics diagnostics;
  auto texture = test::MakeTexture(type, text, ".", &diagnostics);
  EXPECT_THAT(diagnostics.Lines(), IsEmpty());
  return texture;
}

TEST(ConstantTexture, IsTheSameEverywhere) {
  const auto texture = Make("constant", "color 0.5 0.25 2");
  EXPECT_EQ(texture->Lookup(At(3, 4)), (Rgb{0.5f, 0.25f, 2}));
  EXPECT_FALSE(texture->NeedsTextureCoordinates());
}

TEST(CheckerTexture, AlternatesFromUnitToUnit) {
  const auto texture = Make("checker", "even 1 0 0 odd 0 1 0");
  const Rgb even{1, 0, 0}, odd{0, 1, 0};
  EXPECT_EQ(texture->Lookup(At(0.5f, 0.5f)), even);
  EXPECT_EQ(texture->Lookup(At(1.5f, 0.5f)), odd);
  EXPECT_EQ(texture->Lookup(At(1.5f, 1.5f)), even);
  EXPECT_EQ(texture->Lookup(At(-0.5f, 0.5f)), odd);
  EXPECT_EQ(texture->Lookup(At(-0.5f, -0.5f)), even);
  EXPECT_EQ(texture->Lookup(At(1e9f, 0.5f)), even);
}

TEST(CheckerTexture, HasSquaresOfAnySize) {
  const auto texture = Make("checker", "even 1 1 1 odd 0 0 0 scale 4 2");
  EXPECT_EQ(texture->Lookup(At(0.3f, 0.1f)).x, 0);
  EXPECT_EQ(texture->Lookup(At(0.3f, 0.6f)).x, 1);
}

TEST(ColorInput, OfATextureStaysWithinTheLegalRange) {
  const ColorInput input(Make("constant", "color 0.5 2 -1"), {0, 0, 0}, {1, 1, 1});
  EXPECT_TRUE(input.IsTextured());
  EXPECT_EQ(input.At(At(0, 0)), (Rgb{0.5f, 1, 0}));
  EXPECT_EQ(ColorInput(Rgb{0.5f, 2, -1}).At(At(0, 0)), (Rgb{0.5f, 2, -1}));
}

TEST(NumberInput, OfATextureIsItsMean) {
  EXPECT_EQ(NumberInput(Make("constant", "color 0.25 0.5 0.75")).At(At(0, 0)), 0.5f);
  EXPECT_EQ(NumberInput(Make("constant", "color 5 5 5")).At(At(0, 0)), 1.0f);
}

}  // namespace
}  // namespace candela
