// A crop is that part of the whole picture, to the last bit.
#include <gtest/gtest.h>

#include <algorithm>

#include "driver/map_images.h"
#include "render/render_first_hits.h"
#include "tests/determinism/test_cases.h"
#include "tests/support/render_scene.h"

namespace candela::determinism {
namespace {

using testing_support::RenderImage;
using testing_support::ThroughPng;

constexpr int kWidth = 53, kHeight = 40;
constexpr PixelWindow kCrops[] = {
    {0, 0, 53, 40},  {0, 0, 1, 1},    {52, 39, 53, 40}, {7, 5, 40, 38},
    {0, 20, 53, 21}, {26, 0, 27, 40}, {32, 32, 53, 40},
};

Image CutOut(const Image& whole, const PixelWindow& crop) {
  Image part(crop.Width(), crop.Height(), whole.Channels());
  for (int y = 0; y < part.Height(); ++y) {
    for (int x = 0; x < part.Width(); ++x) {
      std::ranges::copy(whole.Pixel(crop.x0 + x, crop.y0 + y), part.Pixel(x, y).begin());
    }
  }
  return part;
}

class Crop : public testing::TestWithParam<std::tuple<const char*, Placement>> {};

TEST_P(Crop, IsThatPartOfTheWhole) {
  const auto& [name, placement] = GetParam();
  const Subject subject = MakeSubject(name, 2);
  ASSERT_TRUE(subject.integrator);
  RenderOptions options = OptionsFor(placement, kWidth, kHeight);
  const Image whole = RenderImage(*subject.integrator, options);
  const Image whole_as_file = ThroughPng(whole);
  for (const PixelWindow& crop : kCrops) {
    options.crop = crop;
    const Image part = RenderImage(*subject.integrator, options);
    EXPECT_TRUE(part == CutOut(whole, crop)) << crop.x0 << ' ' << crop.y0;
    EXPECT_TRUE(ThroughPng(part) == CutOut(whole_as_file, crop)) << crop.x0 << ' ' << crop.y0;
  }
}

INSTANTIATE_TEST_SUITE_P(All, Crop,
                         testing::Combine(testing::Values("whitted", "path", "light_trace"),
                                          testing::ValuesIn(ComparedPlacements())),
                         [](const auto& test) {
                           return std::get<0>(test.param) + ("_" + std::get<1>(test.param).name);
                         });

TEST(CropOfFirstHits, IsThatPartOfTheWhole) {
  const Subject subject = MakeSubject("whitted", 2);
  ASSERT_TRUE(subject.scene);
  RenderOptions options = testing_support::WholePicture(kWidth, kHeight);
  const auto normals = [&] {
    return NormalImage(RenderFirstHits(*subject.scene, options), options.crop, ImageFormat::kPfm);
  };
  const Image whole = normals();
  for (const PixelWindow& crop : kCrops) {
    options.crop = crop;
    EXPECT_TRUE(normals() == CutOut(whole, crop)) << crop.x0 << ' ' << crop.y0;
  }
}

}  // namespace
}  // namespace candela::determinism
