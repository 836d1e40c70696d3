#include "math/wavelength.h"

#include <gtest/gtest.h>

namespace candela {
namespace {

constexpr int kSteps = 300000;

float NumberAt(int i) {
  return (static_cast<float>(i) + 0.5f) / kSteps;
}

// Light that is split keeps its colour in the mean, and nothing counts less than nothing.
TEST(Wavelength, ColoursHaveAMeanOfWhite) {
  double sum[3] = {};
  for (int i = 0; i < kSteps; ++i) {
    const float wavelength = SampleWavelength(NumberAt(i));
    ASSERT_GE(wavelength, kShortestWavelength);
    ASSERT_LE(wavelength, kLongestWavelength);
    const Spectrum colour = ColourOf(wavelength);
    for (int c = 0; c < 3; ++c) {
      ASSERT_GE(colour[c], 0);
      ASSERT_LE(colour[c], 3.00001f);
      sum[c] += static_cast<double>(colour[c]) / kSteps;
    }
  }
  for (const double mean : sum) EXPECT_NEAR(mean, 1, 1e-4);
}

// Each of them at its own end of the rainbow.
TEST(Wavelength, ColoursFollowEachOtherAsInARainbow) {
  double mean[3] = {};
  for (int i = 0; i < kSteps; ++i) {
    const float wavelength = SampleWavelength(NumberAt(i));
    const Spectrum colour = ColourOf(wavelength);
    for (int c = 0; c < 3; ++c) mean[c] += static_cast<double>(colour[c] * wavelength) / kSteps;
  }
  EXPECT_NEAR(mean[0], 620, 0.1);
  EXPECT_NEAR(mean[1], 540, 0.1);
  EXPECT_NEAR(mean[2], 455, 0.1);
}

// At its ends, where nothing is drawn but by rounding, light counts nothing and not infinitely.
TEST(Wavelength, EndsAreFinite) {
  for (const float u : {0.0f, 0x1.fffffep-1f, 1.0f / 3, 2.0f / 3}) {
    const Spectrum colour = ColourOf(SampleWavelength(u));
    EXPECT_LE(colour.MaxComponent(), 3.00001f) << u;
  }
}

}  // namespace
}  // namespace candela
