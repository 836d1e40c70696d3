#include "materials/one_sided.h"

#include <gtest/gtest.h>

#include <memory>

#include "materials/diffuse.h"
#include "materials/mask.h"
#include "tests/materials/scatter.h"
#include "tests/support/compile_text.h"

namespace candela {
namespace {

const Vec3 kUp{0, 0, 1};

TEST(OneSided, IsTheMaterialOnTheOneSideAndBlackOnTheOther) {
  const OneSidedMaterial material(std::make_unique<DiffuseMaterial>(Rgb{0.5f, 0.5f, 0.5f}));
  const Bsdf outside = test::BsdfOf(material, kUp), inside = test::BsdfOf(material, kUp, false);
  EXPECT_GT(Eval(outside, kUp, kUp)[0], 0.1f);
  EXPECT_TRUE(Eval(inside, -kUp, -kUp).IsBlack());
  EXPECT_GT(Sample(outside, kUp, {0.3f, 0.4f}).pdf, 0);
  EXPECT_EQ(Sample(inside, -kUp, {0.3f, 0.4f}).pdf, 0);
}

TEST(OneSided, HasItsHolesOnBothSides) {
  const DiffuseMaterial cloth(Rgb{0.5f, 0.5f, 0.5f});
  const OneSidedMaterial material(std::make_unique<MaskMaterial>(cloth, 0.25f));
  const BsdfSample sample = Sample(test::BsdfOf(material, kUp, false), -kUp, {0.3f, 0.4f});
  EXPECT_TRUE(sample.is_hole);
  EXPECT_EQ(sample.weight[0], 0.75f);
}

TEST(OneSided, IsReadOfAnyMaterial) {
  const auto scene = testing_support::CompileText(std::string(testing_support::kCamera) +
                                                  "Materials { Material { type plastic two_sided "
                                                  "false } Material { type plastic } } Scene { }");
  ASSERT_EQ(scene->materials().size(), 2u);
  EXPECT_EQ(test::BsdfOf(*scene->materials()[0], kUp, false).count, 0);
  EXPECT_EQ(test::BsdfOf(*scene->materials()[1], kUp, false).count, 1);
}

}  // namespace
}  // namespace candela
