// Meshes of few triangles with the normals of the round thing that they stand for.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>

#include "integrators/path.h"
#include "integrators/registry.h"
#include "math/elementary.h"
#include "tests/support/compile_text.h"
#include "tests/support/estimate.h"
#include "tests/support/temp_folder.h"

namespace candela {
namespace {

using testing_support::CompileText;
using testing_support::Estimate;
using testing_support::EstimateRadiance;

/// A globe of `rings` times twice as many faces, with its own normals.
std::string Globe(int rings) {
  std::string text;
  const int turns = 2 * rings;
  for (int ring = 0; ring <= rings; ++ring) {
    for (int turn = 0; turn < turns; ++turn) {
      const double theta = 180.0 * ring / rings, phi = 360.0 * turn / turns;
      const double x = SinDegrees(theta) * CosDegrees(phi), z = SinDegrees(theta) * SinDegrees(phi);
      text += fmt::format("v {0} {1} {2}\nvn {0} {1} {2}\n", x, CosDegrees(theta), z);
    }
  }
  for (int ring = 0; ring < rings; ++ring) {
    for (int turn = 0; turn < turns; ++turn) {
      const int a = ring * turns + turn + 1, b = ring * turns + (turn + 1) % turns + 1;
      if (ring + 1 < rings)
        text += fmt::format("f {0}//{0} {1}//{1} {2}//{2}\n", a, b + turns, a + turns);
      if (ring > 0) text += fmt::format("f {0}//{0} {1}//{1} {2}//{2}\n", a, b, b + turns);
    }
  }
  return text;
}

class RoundedMesh : public testing::Test {
 protected:
  RoundedMesh() { testing_support::Put(folder_ / "globe.obj", Globe(10)); }

  /// A ball in (0, 0, -3) under what lights it.
  std::unique_ptr<const Scene> Ball(const char* object, double albedo, const char* background,
                                    const char* light) {
    return CompileText(
        fmt::format(
            "{0}{1}Materials {{ Material {{ type diffuse albedo {2} {2} {2} }} }}\n"
            "Scene {{ Node {{ Transform {{ translate 0 0 -3 }} Component<Object> {{ type {3} "
            "}} Component<Material> {{ index 0 }} }}\n{4} }}",
            testing_support::kCamera, background, albedo, object, light),
        folder_.path());
  }

  static double Seen(const Scene& scene, Vec2 where, bool lift, uint32_t samples = 64) {
    IntegratorOptions options;
    options.seed = 5;
    PathTechniques techniques;
    techniques.lift = lift;
    return EstimateRadiance(PathIntegrator(scene, options, techniques), where, 8, samples).mean;
  }

  testing_support::TempFolder folder_;
};

// The lamp stands to the right: where the ball turns away from it, its triangles would throw hard
// edged shadows on themselves.
TEST_F(RoundedMesh, HasTheShadingOfTheBallThatItStandsFor) {
  const char* lamp =
      "Node { Component<Light> { type directional direction -1 0.2 0.15 color 1 1 1 } }";
  const auto ball = Ball("sphere radius 1", 0.5, "", lamp);
  const auto mesh = Ball("mesh obj_file globe.obj", 0.5, "", lamp);
  double error_with = 0, error_without = 0, sum = 0;
  for (int i = -25; i <= 25; ++i) {
    for (int j = -5; j <= 5; ++j) {
      const Vec2 where{0.01f * static_cast<float>(i), 0.037f * static_cast<float>(j)};
      const double exact = Seen(*ball, where, true, 4);
      error_with += std::abs(Seen(*mesh, where, true, 4) - exact);
      error_without += std::abs(Seen(*mesh, where, false, 4) - exact);
      sum += exact;
    }
  }
  RecordProperty("error_with", std::to_string(error_with / sum));
  RecordProperty("error_without", std::to_string(error_without / sum));
  EXPECT_LT(error_with, 0.5 * error_without);
  EXPECT_LT(error_with, 0.05 * sum);
}

// No light is made of nothing, and less of it is lost.
TEST_F(RoundedMesh, OfWhiteIsNearlyInvisibleInTheFurnace) {
  const auto mesh = Ball("mesh obj_file globe.obj", 1, "Background { color 1 1 1 }\n", "");
  double with = 0, without = 0;
  int count = 0;
  for (int i = -3; i <= 3; ++i) {
    for (int j = -3; j <= 3; ++j) {
      const Vec2 where{0.07f * static_cast<float>(i), 0.071f * static_cast<float>(j)};
      with += Seen(*mesh, where, true, 512);
      without += Seen(*mesh, where, false, 512);
      ++count;
    }
  }
  with /= count;
  without /= count;
  EXPECT_LE(with, 1 + 1e-3);
  EXPECT_GT(with, without);
  EXPECT_GT(with, 0.98);
}

/// A cube from -1 to 1 with one normal at each corner, as files of it often have.
std::string SmoothCube() {
  std::string text;
  for (int i = 0; i < 8; ++i) {
    const int x = i & 1 ? 1 : -1, y = i & 2 ? 1 : -1, z = i & 4 ? 1 : -1;
    text += fmt::format("v {0} {1} {2}\nvn {0} {1} {2}\n", x, y, z);
  }
  constexpr std::array<int, 4> kSides[] = {{1, 3, 4, 2}, {5, 6, 8, 7}, {1, 2, 6, 5},
                                           {3, 7, 8, 4}, {1, 5, 7, 3}, {2, 4, 8, 6}};
  for (const auto& [a, b, c, d] : kSides) {
    text += fmt::format("f {0}//{0} {1}//{1} {2}//{2}\nf {0}//{0} {2}//{2} {3}//{3}\n", a, b, c, d);
  }
  return text;
}

// The foot of a cube that stands on a floor is lit: no point of it is lifted into the floor.
TEST_F(RoundedMesh, IsNotACubeWhoseEdgesAreSmoothedOver) {
  testing_support::Put(folder_ / "cube.obj", SmoothCube());
  const auto scene = CompileText(
      std::string(testing_support::kCamera) +
          "Materials { Material { type diffuse albedo 0.5 0.5 0.5 } }\n"
          "Scene { Component<Light> { type directional direction 0 -0.5 -1 color 1 1 1 }\n"
          "Node { Transform { translate 0 0 -5 } Component<Object> { type mesh obj_file cube.obj "
          "}\n"
          "Component<Material> { index 0 } }\n"
          "Node { Component<Object> { type plane normal 0 1 0 offset -1 }\n"
          "Component<Material> { index 0 } } }",
      folder_.path());
  for (int i = -8; i <= 8; ++i) {
    const Vec2 foot{0.03f * static_cast<float>(i), -0.24f};  // 0.04 above the floor.
    EXPECT_GT(Seen(*scene, foot, true, 4), 0.02) << i;
    EXPECT_EQ(Seen(*scene, foot, true, 4), Seen(*scene, foot, false, 4)) << i;
  }
}

}  // namespace
}  // namespace candela
