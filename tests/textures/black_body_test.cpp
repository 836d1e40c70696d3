#include "textures/black_body.h"

#include <gtest/gtest.h>

#include "textures/cie_colour.h"

namespace candela {
namespace {

double Luminance(Rgb colour) {
  return 0.2126729 * double{colour.x} + 0.7151522 * double{colour.y} + 0.0721750 * double{colour.z};
}

TEST(BlackBody, HasTheLuminanceOne) {
  for (const double kelvin : {1000., 1900., 2700., 6504., 20000., 40000.}) {
    EXPECT_NEAR(Luminance(BlackBodyColour(kelvin)), 1, 1e-6) << kelvin;
  }
}

// CF36: a body of the colour temperature of daylight is nearly white.
TEST(BlackBody, IsOrangeWhiteAndBlueAsItGetsHotter) {
  const Rgb white = BlackBodyColour(6504), lamp = BlackBodyColour(2700),
            hot = BlackBodyColour(20000);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(white[c], 1, 0.06);
  EXPECT_GT(lamp.x, 2 * lamp.y);
  EXPECT_GT(lamp.y, 3 * lamp.z);
  EXPECT_GT(lamp.z, 0);
  EXPECT_GT(hot.z, 1.5f * hot.y);
  EXPECT_GT(hot.y, 1.2f * hot.x);
  // What is redder than the red of a screen.
  EXPECT_EQ(BlackBodyColour(1000).z, 0);
  EXPECT_GT(BlackBodyColour(1000).y, 0);
}

// CIE standard illuminant A, by the CIE's own tables: x = 0.44758, y = 0.40745.
TEST(BlackBody, HasTheColourOfIlluminantA) {
  const Rgb colour = BlackBodyColour(2855.5);
  const Vec3d rgb = ToDouble(colour);
  const double x = 0.4124564 * rgb.x + 0.3575761 * rgb.y + 0.1804375 * rgb.z;
  const double y = Luminance(colour);
  const double z = 0.0193339 * rgb.x + 0.1191920 * rgb.y + 0.9503041 * rgb.z;
  EXPECT_NEAR(x / (x + y + z), 0.44758, 0.002);
  EXPECT_NEAR(y / (x + y + z), 0.40745, 0.002);
}

}  // namespace
}  // namespace candela
