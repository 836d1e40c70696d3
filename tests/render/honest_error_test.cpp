// P11 on a scene: the reported standard errors hold the truth.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <string>

#include "integrators/registry.h"
#include "render/render_job.h"
#include "tests/support/effort.h"
#include "tests/support/render_scene.h"

namespace candela::testing_support {
namespace {

// Soft shadows, gloss and light from all around.
constexpr const char* kScene = R"(
Camera { center 0 2 6 direction 0 -0.3 -1 up 0 1 0 fov 50 }
Background { color 0.2 0.3 0.5 ambient_light 0 0 0 }
Materials {
  Material { name floor type diffuse albedo 0.7 0.6 0.5 }
  Material { name ball type plastic albedo 0.6 0.2 0.2 roughness 0.3 }
  Material { name lamp type diffuse albedo 0 0 0 }
}
Scene {
  Node {
    Component<Material> { name floor }
    Component<Object> { type plane normal 0 1 0 offset 0 }
  }
  Node {
    Component<Material> { name ball }
    Transform { translate 0 1 0 }
    Component<Object> { type sphere radius 1 }
  }
  Node {
    Component<Material> { name lamp }
    Transform { translate 2 4 1 x_rotate 90 }
    Component<Object> { type rectangle width 1 height 1 }
    Component<Light> { type area radiance 12 12 12 }
  }
}
)";

constexpr int kSide = kIsSanitized ? 32 : 100;

RenderOptions Square(uint32_t samples) {
  RenderOptions options = WholePicture(kSide, kSide);
  options.grid = PixelGrid::kCentres;
  options.pattern = SamplePattern::kFilter;
  options.samples = samples;
  options.drops_negative = true;
  return options;
}

// P11
TEST(HonestError, IntervalsOfAPathTracerHoldTheTruth) {
  const auto scene = SceneOfText(kScene);
  ASSERT_TRUE(scene);
  IntegratorOptions how;
  how.bounces = 2;
  const auto integrator = FindIntegrator("path")->create(*scene, how);
  ASSERT_TRUE(integrator);
  const Image truth = RenderImage(**integrator, Square(1024));
  RenderOptions options = Square(65536);
  options.noise_target = 0.05f;
  options.seed = how.seed = 5;  // Other numbers than those of the truth.
  options.layers = LayerSet{Layer::kStandardError};
  const auto other = FindIntegrator("path")->create(*scene, how);
  ASSERT_TRUE(other);
  RenderJob job(**other, options);
  ASSERT_TRUE(job.Run(CancelToken()));
  int inside = 0;
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      const size_t word = 3 * static_cast<size_t>(kSide * y + x);
      const float error = std::bit_cast<float>(job.film().LayerWords(Layer::kStandardError)[word]);
      // Pixels without noise differ by rounding.
      const float off = std::abs(job.film().Pixel(x, y).x - truth.At(x, y));
      if (off <= 1.96f * error + 1e-5f) ++inside;
    }
  }
  EXPECT_GE(inside, 0.93 * kSide * kSide);
}

}  // namespace
}  // namespace candela::testing_support
