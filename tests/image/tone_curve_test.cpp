#include "image/tone_curve.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "image/image_file.h"

namespace candela {
namespace {

// CF27.
TEST(Srgb, IsTheStandardCurve) {
  EXPECT_NEAR(SrgbFromLinear(0.18f), 0.461356f, 1e-6f);
  EXPECT_NEAR(SrgbFromLinear(0.5f), 0.735357f, 1e-6f);
  EXPECT_NEAR(SrgbFromLinear(0.0031308f), 0.04045f, 1e-6f);
  EXPECT_EQ(SrgbFromLinear(0), 0);
  EXPECT_NEAR(SrgbFromLinear(1), 1, 1e-7f);
  EXPECT_NEAR(LinearFromSrgb(0.5f), 0.214041f, 1e-6f);
}

TEST(Srgb, ComesBack) {
  for (int i = 0; i <= 1000; ++i) {
    const float x = static_cast<float>(i) / 1000;
    EXPECT_NEAR(LinearFromSrgb(SrgbFromLinear(x)), x, 1e-6f);
  }
}

class EachCurve : public testing::TestWithParam<const ToneCurve*> {};

// P16.
TEST_P(EachCurve, GrowsWithTheBrightnessOfAGreyAndStaysInRange) {
  const ToneCurve& curve = *GetParam();
  float last = -1;
  for (int step = 0; step <= 6400; ++step) {
    const float grey = step == 0 ? 0 : std::exp2(static_cast<float>(step) / 100 - 32);
    const Rgb shown = curve.encode({grey, grey, grey});
    for (int c = 0; c < 3; ++c) {
      EXPECT_GE(shown[c], 0);
      EXPECT_LE(shown[c], 1);
      // A tenth of a step of 8 bits: the rows of some curves' matrices do not quite sum to 1.
      EXPECT_NEAR(shown[c], shown.x, 1 / 2550.0f) << "a grey turns coloured at " << grey;
    }
    // Rounding may take a step back of its own size.
    EXPECT_GE(shown.x, last - 1e-6f) << grey;
    last = shown.x;
  }
  EXPECT_GT(last, 0.97f) << "the brightest is not white";
  EXPECT_LT(curve.encode({}).x, 0.005f) << "black is not black";
}

TEST_P(EachCurve, ShowsWhateverFloatsThereAre) {
  const ToneMapping tone{GetParam(), 1};
  for (const float x : {-1.0f, -0.0f, 1e-45f, 3e38f, std::numeric_limits<float>::infinity(),
                        std::numeric_limits<float>::quiet_NaN()}) {
    const Rgb shown = tone.Encode({x, 0, 1});
    for (int c = 0; c < 3; ++c) EXPECT_TRUE(shown[c] >= 0 && shown[c] <= 1) << x;
  }
}

TEST_P(EachCurve, IsFoundByItsName) {
  EXPECT_EQ(FindToneCurve(GetParam()->name), GetParam());
}

std::vector<const ToneCurve*> AllCurves() {
  std::vector<const ToneCurve*> all;
  for (const ToneCurve& curve : ToneCurves()) all.push_back(&curve);
  return all;
}
INSTANTIATE_TEST_SUITE_P(, EachCurve, testing::ValuesIn(AllCurves()),
                         [](const auto& row) { return std::string(row.param->name); });

TEST(ToneMapping, WithoutACurveScalesOnly) {
  EXPECT_EQ((ToneMapping{nullptr, 4}.Encode({0.25f, 1, 2})), (Rgb{1, 4, 8}));
}

// CF27: half of the light is 188 of 255 on a display, rounded; the course's rule cuts to 127.
TEST(ToneMapping, OfAPngRoundsToTheNearestByte) {
  Image image(1, 1, 3, 0.5f);
  EncodeOptions options;
  const auto byte = [&] {
    const auto file = EncodeImage(image, ImageFormat::kPng, options);
    const auto read = DecodeImage(*file);
    return std::lround(read->At(0, 0) * 255);
  };
  EXPECT_EQ(byte(), 127);
  options.tone.curve = FindToneCurve("srgb");
  EXPECT_EQ(byte(), 188);
  options.tone.gain = 2;
  EXPECT_EQ(byte(), 255);
}

TEST(ToneMapping, LeavesPicturesOfLightAlone) {
  const Image image(2, 2, 3, 7.5f);
  EncodeOptions options;
  options.tone = {FindToneCurve("agx"), 8};
  for (const ImageFormat format : {ImageFormat::kExr, ImageFormat::kPfm}) {
    const auto file = EncodeImage(image, format, options);
    EXPECT_EQ(*DecodeImage(*file), image);
  }
}

}  // namespace
}  // namespace candela
