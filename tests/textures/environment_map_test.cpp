#include "textures/environment_map.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <limits>
#include <memory>
#include <string>

#include "image/image_file.h"
#include "math/elementary.h"
#include "sampling/warp.h"
#include "tests/sampling/chi_square.h"
#include "tests/support/temp_folder.h"
#include "textures/lat_long.h"

namespace candela {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(LatLong, HasItsMiddleAheadAndTheZenithAbove) {
  const auto expect_place = [](Vec3 w, float x, float y) {
    EXPECT_NEAR(LatLongOf(w).x, x, 1e-6f);
    EXPECT_NEAR(LatLongOf(w).y, y, 1e-6f);
  };
  expect_place({0, 0, -1}, 0.5f, 0.5f);
  expect_place({1, 0, 0}, 0.75f, 0.5f);
  expect_place({-1, 0, 0}, 0.25f, 0.5f);
  EXPECT_EQ(LatLongOf({0, 1, 0}).y, 0.0f);
  EXPECT_NEAR(LatLongOf({0, -1, 0}).y, 1, 1e-6f);
}

TEST(LatLong, Inverts) {
  test::UniformNumbers numbers(1);
  for (int i = 0; i < 10000; ++i) {
    const Vec3 w = SampleUniformSphere(numbers.NextPair());
    ASSERT_LT(Length(DirectionOfLatLong(LatLongOf(w)) - w), 2e-6f);
  }
}

/// One texel of eight is red: the one in the upper half, right of the middle.
Image OneRedTexel() {
  Image image(4, 2, 3);
  image.At(2, 0, 0) = 6;
  return image;
}

TEST(EnvironmentMap, ShowsATexelInItsMiddle) {
  const EnvironmentMap map(OneRedTexel(), 1, 0);
  EXPECT_NEAR(map.Lookup(DirectionOfLatLong({0.625f, 0.25f})).x, 6, 1e-4f);
  EXPECT_NEAR(map.Lookup(DirectionOfLatLong({0.5f, 0.25f})).x, 3, 1e-4f);
  EXPECT_NEAR(map.Lookup(DirectionOfLatLong({0.125f, 0.25f})).x, 0, 1e-4f);
}

TEST(EnvironmentMap, BlendsAcrossItsSeam) {
  Image image(4, 2, 3);
  image.At(0, 0, 0) = image.At(0, 1, 0) = 8;
  const EnvironmentMap map(image, 1, 0);
  EXPECT_NEAR(map.Lookup(DirectionOfLatLong({0.9999999f, 0.5f})).x, 4, 1e-4f);
  EXPECT_NEAR(map.Lookup(DirectionOfLatLong({0, 0.5f})).x, 4, 1e-4f);
}

// What lay ahead, at -z, lies at -x after a quarter turn against the clock.
TEST(EnvironmentMap, TurnsAgainstTheClockSeenFromAbove) {
  Image image(64, 2, 3);
  for (int x = 30; x < 34; ++x) image.At(x, 0, 0) = image.At(x, 1, 0) = 1;
  EXPECT_GT(EnvironmentMap(image, 1, 0).Lookup({0, 0, -1}).x, 0.9f);
  for (const float degrees : {90.0f, 450.0f, -270.0f}) {
    EXPECT_GT(EnvironmentMap(image, 1, degrees).Lookup({-1, 0, 0}).x, 0.9f) << degrees;
    EXPECT_EQ(EnvironmentMap(image, 1, degrees).Lookup({0, 0, -1}).x, 0.0f) << degrees;
  }
}

TEST(EnvironmentMap, IsScaled) {
  EXPECT_NEAR(EnvironmentMap(OneRedTexel(), 2.5f, 0).Lookup(DirectionOfLatLong({0.625f, 0.25f})).x,
              15, 1e-3f);
}

// The mean over a cell of the blended picture: 6/8 each way of its own texel, and 1/8 of the next.
TEST(EnvironmentMap, MeansOfCellsAreThoseOfTheBlend) {
  const std::vector<float> means = EnvironmentMap(OneRedTexel(), 1, 0).MeansOfCells();
  const float third = 2;                       // The mean of the colours of the red texel.
  EXPECT_FLOAT_EQ(means[2], third * 42 / 64);  // Its row stands for the one above, too.
  EXPECT_FLOAT_EQ(means[1], third * 7 / 64);
  EXPECT_FLOAT_EQ(means[6], third * 6 / 64);
  EXPECT_EQ(means[0], 0.0f);
}

class EnvironmentFile : public testing::Test {
 protected:
  std::vector<std::string> LinesAbout(const std::string& name, const std::string& bytes) {
    testing_support::Put(folder_ / name, bytes);
    return Load(name);
  }
  std::vector<std::string> Load(const std::string& name) {
    Diagnostics diagnostics;
    const SourceLocation asked{std::make_shared<const std::string>("scene.txt"), 3, 5};
    map_ = EnvironmentMap::Load(folder_ / name, asked, 1, 0, &diagnostics);
    return diagnostics.Lines();
  }
  std::string Encoded(const Image& image, ImageFormat format) {
    const auto bytes = EncodeImage(image, format);
    EXPECT_TRUE(bytes.ok());
    return *bytes;
  }

  testing_support::TempFolder folder_;
  std::optional<EnvironmentMap> map_;
};

TEST_F(EnvironmentFile, MayBeOfAnyKindOfPicture) {
  for (const auto& [name, format] :
       {std::pair{"a.exr", ImageFormat::kExr}, std::pair{"a.hdr", ImageFormat::kHdr},
        std::pair{"a.pfm", ImageFormat::kPfm}}) {
    EXPECT_THAT(LinesAbout(name, Encoded(OneRedTexel(), format)), IsEmpty());
    ASSERT_TRUE(map_) << name;
    EXPECT_NEAR(map_->Lookup(DirectionOfLatLong({0.625f, 0.25f})).x, 6, 0.05f) << name;
  }
}

TEST_F(EnvironmentFile, ThatIsGreyShinesInAllColours) {
  EXPECT_THAT(LinesAbout("grey.exr", Encoded(Image(4, 2, 1, 3.0f), ImageFormat::kExr)), IsEmpty());
  ASSERT_TRUE(map_);
  EXPECT_EQ(map_->Lookup({0, 0, -1}), (Rgb{3, 3, 3}));
}

TEST_F(EnvironmentFile, ThatIsMissingIsReportedWhereItIsAskedFor) {
  EXPECT_THAT(Load("none.exr"), ElementsAre(HasSubstr("scene.txt:3:5: error: environment")));
  EXPECT_FALSE(map_);
}

TEST_F(EnvironmentFile, ThatIsNoPictureIsNamed) {
  EXPECT_THAT(LinesAbout("text.exr", "hello"),
              ElementsAre(HasSubstr("text.exr: error: this is not a PNG, JPEG, EXR, HDR or PFM")));
}

TEST_F(EnvironmentFile, ThatIsCutShortIsNamed) {
  const std::string bytes = Encoded(OneRedTexel(), ImageFormat::kExr);
  for (const size_t length : {bytes.size() - 1, bytes.size() / 2, size_t{20}}) {
    const auto lines = LinesAbout("cut.exr", bytes.substr(0, length));
    ASSERT_FALSE(lines.empty());
    EXPECT_THAT(lines[0], HasSubstr("cut.exr: error: "));
    EXPECT_FALSE(map_);
  }
}

TEST_F(EnvironmentFile, OfHugeSizeIsRefusedBeforeMemoryIsTaken) {
  const std::string header = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 2000000000 +X 2000000000\n";
  const auto lines = LinesAbout("huge.hdr", header);
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_THAT(lines[0], HasSubstr("huge.hdr: error: "));
  EXPECT_FALSE(map_);
}

TEST_F(EnvironmentFile, WithAPixelThatIsNotANumberIsAnError) {
  Image image = OneRedTexel();
  image.At(1, 1, 2) = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THAT(LinesAbout("nan.exr", Encoded(image, ImageFormat::kExr)),
              ElementsAre(HasSubstr("nan.exr: error: pixel (1, 1) of the environment is not")));
  image.At(1, 1, 2) = std::numeric_limits<float>::infinity();
  LinesAbout("inf.exr", Encoded(image, ImageFormat::kExr));
  EXPECT_FALSE(map_);
}

TEST_F(EnvironmentFile, WithNegativeLightIsMendedWithAWarning) {
  Image image = OneRedTexel();
  image.At(0, 0, 1) = -1;
  image.At(0, 0, 2) = -2;
  EXPECT_THAT(LinesAbout("negative.exr", Encoded(image, ImageFormat::kExr)),
              ElementsAre(HasSubstr("warning: 2 negative values of the environment became 0")));
  ASSERT_TRUE(map_);
  EXPECT_EQ(map_->Lookup(DirectionOfLatLong({0.125f, 0.25f})).y, 0.0f);
}

}  // namespace
}  // namespace candela
