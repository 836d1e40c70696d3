// What becomes of a radiance on its way into a file of the course's kind: no curve, no rounding.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>

#include "image/quantise.h"
#include "integrators/whitted.h"
#include "render/render_job.h"
#include "tests/support/compile_text.h"

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

TEST(CourseOutput, TruncatesInsteadOfRounding) {
  EXPECT_EQ(ByteOf("0.5"), 127);
  EXPECT_EQ(ByteOf("0.999"), 254);
  EXPECT_EQ(ByteOf("0.0039"), 0);
}

TEST(CourseOutput, AppliesNoCurve) {
  EXPECT_EQ(ByteOf("0.18"), 45);
  EXPECT_EQ(ByteOf("0.0031308"), 0);
}

TEST(CourseOutput, ClampsAtWhite) {
  EXPECT_EQ(ByteOf("1"), 255);
  EXPECT_EQ(ByteOf("1.44"), 255);
  EXPECT_EQ(ByteOf("1e30"), 255);
}

}  // namespace
}  // namespace candela
