// What integrators record for layers.
#include <gtest/gtest.h>

#include <array>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "integrators/registry.h"
#include "tests/support/compile_text.h"

namespace candela {
namespace {

using testing_support::CompileText;
using testing_support::kCamera;

struct Recorded {
  std::vector<Spectrum> radiance;
  std::vector<SampleLayers> layers;
};

IntegratorOptions Bounces(uint32_t bounces) {
  IntegratorOptions options;
  options.bounces = bounces;
  options.shadows = true;
  return options;
}

/// "distribution" is `whitted` with several rays.
Result<std::unique_ptr<Integrator>> Make(std::string_view integrator, const Scene& scene,
                                         IntegratorOptions options) {
  if (integrator != "distribution") return CreateIntegrator(integrator, scene, options);
  options.light_samples = 3;
  options.indirect_samples = 4;
  return CreateIntegrator("whitted", scene, options);
}

Recorded Record(std::string_view integrator, const Scene& scene,
                const std::vector<SampleRequest>& requests, const IntegratorOptions& options) {
  const auto made = Make(integrator, scene, options);
  EXPECT_TRUE(made.ok());
  Recorded recorded;
  recorded.radiance.resize(requests.size());
  recorded.layers.resize(requests.size());
  (*made)->Trace(requests, (*made)->MakeWorkspace().get(),
                 {recorded.radiance, recorded.layers, true});
  return recorded;
}

std::vector<SampleRequest> Grid() {
  std::vector<SampleRequest> requests;
  for (uint32_t i = 0; i < 400; ++i) {
    const auto x = static_cast<float>(i % 20) / 10 - 0.95f;
    const auto y = 0.95f - static_cast<float>(i / 20) / 10;
    requests.push_back({i % 20, i / 20, i % 5, {x, y}});
  }
  return requests;
}

class EveryRecorder : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Integrators, EveryRecorder,
                         testing::Values("whitted", "path", "distribution"),
                         [](const auto& test) { return std::string(test.param); });

const std::string kStillLife =
    std::string(kCamera) +
    "Background { color 0.2 0.3 0.5 ambient_light 0.1 0.1 0.1 }\n"
    "Materials { Material { type diffuse albedo 0.8 0.6 0.4 }\n"
    "  Material { type mirror reflectance 0.9 0.9 0.9 } }\n"
    "Scene {\n"
    "Node { Transform { translate 0 0 -4 } Component<Object> { type sphere radius 1 }\n"
    "  Component<Material> { index 0 } }\n"
    "Node { Transform { translate 2 0 -4 } Component<Object> { type sphere radius 0.9 }\n"
    "  Component<Material> { index 1 } }\n"
    "Node { Component<Object> { type plane normal 0 1 0 offset -1 }\n"
    "  Component<Material> { index 0 } }\n"
    "Node { Transform { translate -1 1.5 -4 } Component<Object> { type sphere radius 0.4 }\n"
    "  Component<Material> { index 0 } Component<Light> { type area radiance 4 3 2 } }\n"
    "Node { Transform { translate 3 4 0 } Component<Light> { type point attenuation 0.1 } } }";

TEST_P(EveryRecorder, LightScatteredNeverOnceAndMoreOftenIsAllLight) {
  const auto scene = CompileText(kStillLife);
  const Recorded seen = Record(GetParam(), *scene, Grid(), Bounces(5));
  std::array<float, 3> sums{};
  for (size_t i = 0; i < seen.radiance.size(); ++i) {
    const auto& light = seen.layers[i].light;
    const Rgb radiance = seen.radiance[i].ToRgb(), all = light[0] + light[1] + light[2];
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(all[c], radiance[c], 1e-6f * (1 + radiance[c])) << i;
    for (size_t k = 0; k < 3; ++k) sums[k] += light[k].x;
  }
  for (const float sum : sums) EXPECT_GT(sum, 1);
}

TEST_P(EveryRecorder, RecordingChangesNoLight) {
  const auto scene = CompileText(kStillLife);
  const auto made = Make(GetParam(), *scene, Bounces(3));
  ASSERT_TRUE(made.ok());
  const auto requests = Grid();
  std::vector<Spectrum> radiance(requests.size());
  (*made)->Trace(requests, (*made)->MakeWorkspace().get(), {radiance});
  EXPECT_TRUE(Record(GetParam(), *scene, requests, Bounces(3)).radiance == radiance);
}

TEST_P(EveryRecorder, RecordsTheSurfaceThatTheCameraSees) {
  const auto scene = CompileText(kStillLife);
  for (const uint32_t bounces : {0u, 2u}) {
    const Recorded seen =
        Record(GetParam(), *scene, {{0, 0, 0, {0, 0}}, {1, 0, 0, {0, 0.9f}}, {0, 1, 0, {0, -1}}},
               Bounces(bounces));
    const SampleLayers::Surface& sphere = seen.layers[0].surface;
    EXPECT_EQ(sphere.object, 1u);
    EXPECT_EQ(sphere.material, 1u);
    EXPECT_NEAR(sphere.depth, 3, 1e-5);
    EXPECT_NEAR(Length(sphere.position - Vec3{0, 0, -3}), 0, 1e-5);
    EXPECT_NEAR(Length(sphere.n_shading - Vec3{0, 0, 1}), 0, 1e-5);
    EXPECT_NEAR(Length(sphere.n_geometric - Vec3{0, 0, 1}), 0, 1e-5);
    EXPECT_NEAR(Length(seen.layers[0].albedo - Rgb{0.8f, 0.6f, 0.4f}), 0, 1e-6);

    EXPECT_EQ(seen.layers[1].surface, SampleLayers::Surface());
    EXPECT_EQ(seen.layers[1].albedo, Rgb());

    // The floor is 1 below and, at 45 degrees, 1 ahead, but sqrt(2) along the ray.
    const SampleLayers::Surface& floor = seen.layers[2].surface;
    EXPECT_EQ(floor.object, 3u);
    EXPECT_NEAR(floor.depth, 1, 1e-5);
    EXPECT_NEAR(Length(floor.n_shading - Vec3{0, 1, 0}), 0, 1e-5);
  }
}

TEST_P(EveryRecorder, NormalsPointToTheCamera) {
  const auto scene = CompileText(
      std::string(kCamera) +
      "Background { color 0 0 0 ambient_light 1 1 1 }\n"
      "Materials { Material { type diffuse albedo 1 1 1 } }\n"
      "Scene { Component<Object> { type sphere radius 2 } Component<Material> { index 0 } }");
  const Recorded seen = Record(GetParam(), *scene, {{0, 0, 0, {0, 0}}}, Bounces(0));
  EXPECT_NEAR(Length(seen.layers[0].surface.n_shading - Vec3{0, 0, 1}), 0, 1e-5);
}

/// The light of each group, sample after sample.
std::vector<Rgb> RecordGroups(std::string_view integrator, const Scene& scene,
                              const std::vector<SampleRequest>& requests,
                              std::vector<Spectrum>* radiance) {
  const auto made = CreateIntegrator(integrator, scene, Bounces(5));
  EXPECT_TRUE(made.ok());
  std::vector<Rgb> groups(requests.size() * scene.light_groups().size(), Rgb{7, 7, 7});
  radiance->resize(requests.size());
  SampleOutput output{*radiance};
  output.group_light = groups;
  output.group_count = scene.light_groups().size();
  (*made)->Trace(requests, (*made)->MakeWorkspace().get(), output);
  return groups;
}

// The sky is blue, the ball red and the lamp green; the floor is grey and the mirror too.
TEST(LightGroups, HoldWhatTheirLightsSendAndNothingElse) {
  const auto scene = CompileText(
      std::string(kCamera) +
      "Background { color 0 0 0.5 }\n"
      "Materials { Material { type diffuse albedo 0.8 0.8 0.8 }\n"
      "  Material { type mirror reflectance 0.9 0.9 0.9 } }\n"
      "Scene {\n"
      "Node { Transform { translate 1 0 -4 } Component<Object> { type sphere radius 0.9 }\n"
      "  Component<Material> { index 1 } }\n"
      "Node { Component<Object> { type plane normal 0 1 0 offset -1 }\n"
      "  Component<Material> { index 0 } }\n"
      "Node { Transform { translate -1 0.5 -4 } Component<Object> { type sphere radius 0.4 }\n"
      "  Component<Material> { index 0 } Component<Light> { type area radiance 3 0 0 group b } }\n"
      "Node { Component<Light> { type directional direction 0 -1 -1 color 1 0 0 angle 20 group b } "
      "}\n"
      "Node { Transform { translate 0 4 0 }\n"
      "  Component<Light> { type point color 0 1 0 attenuation 0.1 group a } } }");
  EXPECT_EQ(scene->light_groups(), (std::vector<std::string>{"default", "b", "a"}));
  for (const char* integrator : {"path", "direct"}) {
    SCOPED_TRACE(integrator);
    std::vector<Spectrum> radiance;
    const std::vector<Rgb> groups = RecordGroups(integrator, *scene, Grid(), &radiance);
    const int channels[] = {2, 0, 1};
    std::array<float, 3> sums{};
    for (size_t i = 0; i < radiance.size(); ++i) {
      for (size_t group = 0; group < 3; ++group) {
        Rgb expected;
        const int channel = channels[group];
        expected[channel] = radiance[i].ToRgb()[channel];
        const Rgb& found = groups[3 * i + group];
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(found[c], expected[c], 2e-6f * (1 + expected[c]));
        sums[group] += found[channel];
      }
    }
    for (const float sum : sums) EXPECT_GT(sum, 1);
  }
}

// In a room of reflectance 1/2 that emits 1/2, light that was scattered n times is 1/2^(n+1).
TEST(PathLayers, LightHalvesWithEachBounce) {
  const auto scene = CompileText(
      std::string(kCamera) +
      "Materials { Material { type diffuse albedo 0.5 0.5 0.5 } }\n"
      "Scene { Component<Object> { type sphere radius 1 } Component<Material> { index 0 }\n"
      "  Component<Light> { type area radiance 0.5 0.5 0.5 } }");
  const Recorded seen = Record("path", *scene, Grid(), Bounces(2));
  std::array<double, 3> means{};
  for (const SampleLayers& sample : seen.layers) {
    for (size_t k = 0; k < 3; ++k) means[k] += static_cast<double>(sample.light[k].x) / 400;
  }
  EXPECT_NEAR(means[0], 0.5, 1e-6);
  EXPECT_NEAR(means[1], 0.25, 1e-5);
  EXPECT_NEAR(means[2], 0.125, 1e-5);
}

// Without a texture nobody else asks for them.
TEST(PathLayers, TextureCoordinatesAreThereWithoutATexture) {
  const auto scene = CompileText(
      std::string(kCamera) +
      "Materials { Material { type diffuse albedo 1 1 1 } }\n"
      "Scene { Component<Object> { type triangle vertex0 -1 -1 -1 vertex1 3 -1 -1 vertex2 -1 3 -1 }"
      "  Component<Material> { index 0 } }");
  const Recorded seen = Record("path", *scene, {{0, 0, 0, {0, 0.5f}}}, Bounces(1));
  EXPECT_NEAR(seen.layers[0].surface.uv.x, 0.25f, 1e-6);
  EXPECT_NEAR(seen.layers[0].surface.uv.y, 0.375f, 1e-6);
}

// The first surface that is there: water that lies inside of glass is not.
TEST(PathLayers, AreOfTheFirstSurfaceThatIsNotHidden) {
  const auto scene = CompileText(
      std::string(kCamera) +
      "Media { Medium { name water ior 1.333 } }\n"
      "Materials { Material { name clear type dielectric } }\n"
      "Scene {\n"
      "Node { Transform { translate 0 0 -4 } Component<Object> { type sphere radius 1 }\n"
      "  Component<Material> { name clear } Component<Interior> { medium water priority 1 } }\n"
      "Node { Component<Object> { type sphere radius 20 }\n"
      "  Component<Material> { name clear } Component<Interior> { medium glass priority 2 } } }");
  const Recorded seen = Record("path", *scene, {{0, 0, 0, {0, 0}}}, Bounces(4));
  EXPECT_EQ(seen.layers[0].surface.object, 2u);
  EXPECT_NEAR(seen.layers[0].surface.depth, 20, 1e-4);
}

}  // namespace
}  // namespace candela
