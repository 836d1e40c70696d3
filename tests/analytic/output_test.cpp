// What becomes of a radiance on its way into a file: in one of the course's kind no curve and no
// rounding, in one of floats nothing at all.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "image/image_file.h"
#include "image/quantise.h"
#include "integrators/whitted.h"
#include "render/render_job.h"
#include "tests/support/compile_text.h"
#include "tests/support/image_function.h"
#include "tests/support/render_scene.h"

namespace candela {
namespace {

/// The byte of a pixel that shows a background of the given value.
uint8_t ByteOf(const std::string& value) {
  const auto scene = testing_support::CompileText(
      testing_support::kCamera +
      fmt::format("Background {{ color {0} {0} {0} ambient_light 0 0 0 }} Scene {{ }}", value));
  const WhittedIntegrator integrator(*scene, 0, false);
  RenderOptions options;
  options.width = options.height = 1;
  options.crop = {0, 0, 1, 1};
  RenderJob job(integrator, options);
  EXPECT_TRUE(job.Run(CancelToken()).ok());
  return QuantiseToByte(job.film().Pixel(0, 0).x);
}

// CF27
TEST(CourseOutput, TruncatesInsteadOfRounding) {
  EXPECT_EQ(ByteOf("0.5"), 127);
  EXPECT_EQ(ByteOf("0.999"), 254);
  EXPECT_EQ(ByteOf("0.0039"), 0);
}

// CF27
TEST(CourseOutput, AppliesNoCurve) {
  EXPECT_EQ(ByteOf("0.18"), 45);
  EXPECT_EQ(ByteOf("0.0031308"), 0);
}

// CF27
TEST(CourseOutput, ClampsAtWhite) {
  EXPECT_EQ(ByteOf("1"), 255);
  EXPECT_EQ(ByteOf("1.44"), 255);
  EXPECT_EQ(ByteOf("1e30"), 255);
}

/// The levels of a wide range of light, from far below what a display can show to far above it:
/// pixel i of a row has 2^(i - 33), about. Sums go up to 2^40.
constexpr int kLevels = 72;
float Level(int i) {
  return std::ldexp(1.0f + static_cast<float>(i) / 97, i - 33);
}

/// A render of one row of these, through film and sums.
Image RowOfLevels() {
  const testing_support::ImageFunction levels(
      [](Vec2 p) { return Level(static_cast<int>((p.x / kLevels + 1) / 2 * kLevels)); });
  RenderOptions options = testing_support::WholePicture(kLevels, 1);
  options.grid = PixelGrid::kCentres;
  return testing_support::RenderImage(levels, options);
}

Image ThroughFile(const Image& image, ImageFormat format, const EncodeOptions& options = {}) {
  const auto bytes = EncodeImage(image, format, options);
  EXPECT_TRUE(bytes.ok());
  const auto back = DecodeImage(*bytes);
  EXPECT_TRUE(back.ok());
  return *back;
}

// P16: what is brighter than 1 comes out as it is, and what is darker than a millionth at least to
// the precision of a half: sums have 44 bits behind the point. Files change nothing of it.
TEST(FloatOutput, HoldsLightAboveOneAndBelowAMillionthUnchanged) {
  const Image rendered = RowOfLevels();
  for (int i = 0; i < kLevels; ++i) {
    EXPECT_NEAR(rendered.At(i, 0), Level(i), Level(i) / 2048) << i;
    if (Level(i) >= 1e-6f) {
      EXPECT_EQ(rendered.At(i, 0), Level(i)) << i;
    }
  }
  EXPECT_EQ(ThroughFile(rendered, ImageFormat::kExr), rendered);
  EXPECT_EQ(ThroughFile(rendered, ImageFormat::kPfm), rendered);
}

// P16: the mean of many samples is as good.
TEST(FloatOutput, OfManySamplesHoldsSmallLightToHalfPrecision) {
  for (const float level : {1e-9f, 3e-7f, 0.3f, 70000.0f}) {
    const testing_support::ImageFunction even([=](Vec2) { return level; });
    RenderOptions options = testing_support::WholePicture(1, 1);
    options.pattern = SamplePattern::kFilter;
    options.samples = 7;
    EXPECT_NEAR(testing_support::RenderImage(even, options).At(0, 0), level, level / 2048);
  }
}

// P16: three mantissas of eight bits with a common exponent, of which a grey uses the last bit:
// half a step is 1 / 256 of it.
TEST(FloatOutput, OfAnHdrFileKeepsEightBits) {
  const Image rendered = RowOfLevels();
  const Image back = ThroughFile(rendered, ImageFormat::kHdr);
  for (int i = 0; i < kLevels; ++i) {
    EXPECT_NEAR(back.At(i, 0), rendered.At(i, 0), rendered.At(i, 0) / 256) << i;
  }
}

// P16: half a step of 16 bits; the sum rounds once more in single precision.
TEST(WordOutput, IsWithinHalfAStep) {
  constexpr int kWidth = 1000;
  const testing_support::ImageFunction ramp([](Vec2 p) { return (p.x / kWidth + 1) / 2; });
  RenderOptions options = testing_support::WholePicture(kWidth, 1);
  options.grid = PixelGrid::kCentres;
  const Image rendered = testing_support::RenderImage(ramp, options);
  EncodeOptions words;
  words.png_bits = 16;
  const Image back = ThroughFile(rendered, ImageFormat::kPng, words);
  for (int x = 0; x < kWidth; ++x) {
    EXPECT_NEAR(back.At(x, 0), rendered.At(x, 0), (0.5 + 1.0 / 128) / 65535) << x;
  }
}

// P16: a tone curve is for eyes; files of light do not get it.
TEST(FloatOutput, GetsNoToneCurve) {
  EncodeOptions options;
  options.tone = {FindToneCurve("srgb"), 4};
  const Image rendered = RowOfLevels();
  EXPECT_EQ(ThroughFile(rendered, ImageFormat::kExr, options), rendered);
  EXPECT_EQ(ThroughFile(rendered, ImageFormat::kPfm, options), rendered);
  EXPECT_EQ(ThroughFile(rendered, ImageFormat::kHdr, options),
            ThroughFile(rendered, ImageFormat::kHdr));
}

}  // namespace
}  // namespace candela
