#include "lights/ies_light.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>

#include "lights/light_context.h"
#include "math/elementary.h"
#include "tests/support/compile_text.h"
#include "tests/support/temp_folder.h"

namespace candela {
namespace {

using testing_support::CompileText;

/// A lamp whose light goes down and to the horizontal angle of 0, its file in a folder of its own.
class MeasuredLamp : public testing::Test {
 protected:
  MeasuredLamp() {
    testing_support::Put(folder_.path() / "lamp.ies",
                         "IESNA91\nTILT=INCLUDE\n1\n2\n0 90\n1 0.5\n"
                         "1 1000 1 3 3 1 2 0 0 0 1 1 10\n0 45 90\n0 90 180\n"
                         "600 300 0\n600 100 0\n600 50 0\n");
  }

  std::unique_ptr<const Scene> Lit(const std::string& transform,
                                   const std::string& more = "scale 1") {
    return CompileText(fmt::format("{}Scene {{ Node {{ Transform {{ {} }} Component<Light> {{ "
                                   "type ies file lamp.ies {} }} }} }}",
                                   testing_support::kCamera, transform, more),
                       folder_.path());
  }

  static float LightAt(const Scene& scene, Vec3 p) {
    return scene.lights()[0]->SampleIncident(p).radiance[0];
  }

  testing_support::TempFolder folder_;
};

// I / h^2 straight below.
TEST_F(MeasuredLamp, GivesItsIntensityOverTheSquaredDistance) {
  const auto scene = Lit("translate 0 2 0");
  EXPECT_FLOAT_EQ(LightAt(*scene, {0, 0, 0}), 150);
  EXPECT_FLOAT_EQ(LightAt(*scene, {0, -1, 0}), 600 / 9.0f);
  EXPECT_EQ(LightAt(*scene, {0, 3, 0}), 0);
}

// The horizontal angle of 0 is +x, that of 90 is -z; at 45 degrees the squared distance is 8.
TEST_F(MeasuredLamp, LiesInItsNode) {
  const auto scene = Lit("translate 0 2 0");
  EXPECT_NEAR(LightAt(*scene, {2, 0, 0}), 300 / 8.0f, 1e-3f);
  EXPECT_NEAR(LightAt(*scene, {0, 0, -2}), 100 / 8.0f, 1e-3f);
  EXPECT_NEAR(LightAt(*scene, {-2, 0, 0}), 50 / 8.0f, 1e-3f);
  EXPECT_NEAR(LightAt(*scene, {0, 0, 2}), 100 / 8.0f, 1e-3f);
}

TEST_F(MeasuredLamp, TurnsWithItsNode) {
  const auto turned = Lit("translate 0 2 0 y_rotate 90");
  EXPECT_NEAR(LightAt(*turned, {0, 0, -2}), 300 / 8.0f, 1e-3f);
  EXPECT_NEAR(LightAt(*turned, {-2, 0, 0}), 100 / 8.0f, 1e-3f);
  const auto mirrored = Lit("translate 0 2 0 scale -3 1 1");
  EXPECT_NEAR(LightAt(*mirrored, {-2, 0, 0}), 300 / 8.0f, 1e-3f);
}

// Half of the light is left at 90 degrees.
TEST_F(MeasuredLamp, LosesLightWhereItsFileSaysSoOfTilt) {
  EXPECT_FLOAT_EQ(LightAt(*Lit("z_rotate 90"), {2, 0, 0}), 75);
  EXPECT_FLOAT_EQ(LightAt(*Lit("x_rotate 30"), Vec3{0, -0.8660254f, -0.5f} * 2), 125);
}

TEST_F(MeasuredLamp, HasAColourAndAScale) {
  const auto scene = Lit("", "color 1 0.5 0 scale 0.01");
  const Rgb light = scene->lights()[0]->SampleIncident({0, -1, 0}).radiance.ToRgb();
  EXPECT_FLOAT_EQ(light.x, 6);
  EXPECT_FLOAT_EQ(light.y, 3);
  EXPECT_EQ(light.z, 0);
  EXPECT_FLOAT_EQ(LightAt(*Lit("", ""), {0, -1, 0}), 0.6f) << "in kilolux, unless it is said";
}

TEST_F(MeasuredLamp, HasThePowerOfItsFlux) {
  const auto scene = Lit("");
  Diagnostics diagnostics;
  const auto file = ReadIesFile(folder_.path() / "lamp.ies", {}, nullptr, &diagnostics);
  ASSERT_TRUE(file);
  EXPECT_NEAR(double{scene->lights()[0]->Power({})} / file->profile.Flux(), 1, 1e-6);
}

}  // namespace
}  // namespace candela
