// What holds for every integrator, by way of the render job where it is about pictures.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "base/parallel.h"
#include "cameras/registry.h"
#include "integrators/registry.h"
#include "render/render_job.h"
#include "tests/sampling/chi_square.h"
#include "tests/support/compile_text.h"

namespace candela {
namespace {

using testing_support::CompileText;
using testing_support::kCamera;

/// The rows of which something holds, or does not.
std::vector<IntegratorEntry> RowsWhere(bool IntegratorEntry::*fact, bool holds = true) {
  std::vector<IntegratorEntry> rows;
  for (const IntegratorEntry& entry : IntegratorEntries()) {
    if (entry.*fact == holds) rows.push_back(entry);
  }
  return rows;
}

std::vector<std::string_view> NamesOf(const std::vector<IntegratorEntry>& rows) {
  std::vector<std::string_view> names;
  for (const IntegratorEntry& entry : rows) names.push_back(entry.name);
  return names;
}

// The furnace is not for these rows.
TEST(IntegratorContract, TheseRowsAreNotPhysical) {
  EXPECT_THAT(NamesOf(RowsWhere(&IntegratorEntry::is_physical, false)),
              testing::ElementsAre("whitted", "direct", "ambient_occlusion", "debug"));
}

TEST(IntegratorContract, TheseRowsTellGroupsOfLightsApart) {
  EXPECT_THAT(NamesOf(RowsWhere(&IntegratorEntry::has_light_groups)),
              testing::ElementsAre("path", "direct"));
}

std::string RowName(const testing::TestParamInfo<IntegratorEntry>& row) {
  return std::string(row.param.name);
}

std::unique_ptr<Integrator> Create(const IntegratorEntry& entry, const Scene& scene) {
  IntegratorOptions options;
  options.bounces = 6;
  options.shadows = true;
  auto integrator = entry.create(scene, options);
  EXPECT_TRUE(integrator.ok());
  return std::move(integrator).value();
}

class EveryIntegrator : public testing::TestWithParam<IntegratorEntry> {};

INSTANTIATE_TEST_SUITE_P(Registry, EveryIntegrator,
                         testing::ValuesIn(IntegratorEntries().begin(), IntegratorEntries().end()),
                         RowName);

TEST_P(EveryIntegrator, CanBeAskedForByName) {
  const auto scene = CompileText(std::string(kCamera) + "Scene { }");
  EXPECT_TRUE(CreateIntegrator(GetParam().name, *scene, {}).ok());
  EXPECT_FALSE(GetParam().description.empty());
}

TEST_P(EveryIntegrator, AnEmptySceneShowsTheBackground) {
  const auto scene = CompileText(
      std::string(kCamera) + "Background { color 0.25 0.5 0.75 ambient_light 1 1 1 } Scene { }");
  const auto integrator = Create(GetParam(), *scene);
  const auto workspace = integrator->MakeWorkspace();
  const SampleRequest requests[] = {{0, 0, 0, {0, 0}}, {5, 3, 1, {1, -1}}};
  Spectrum radiance[2];
  integrator->Trace(requests, workspace.get(), {radiance});
  EXPECT_EQ(radiance[0].ToRgb(), (Rgb{0.25f, 0.5f, 0.75f}));
  EXPECT_EQ(radiance[1].ToRgb(), (Rgb{0.25f, 0.5f, 0.75f}));
  EXPECT_EQ(workspace->rays.Total(), 2u);
}

// Where a camera shows nothing the picture is black, and nothing is said of a surface.
TEST_P(EveryIntegrator, EveryCameraShowsTheBackgroundWhereItShowsSomething) {
  for (const CameraEntry& camera : CameraEntries()) {
    SCOPED_TRACE(camera.name);
    const auto scene = CompileText(
        fmt::format("Camera {{ center 1 2 3 direction 1 0 -1 up 0 1 0 {} }}\n"
                    "Background {{ color 0.25 0.5 0.75 ambient_light 1 1 1 }} Scene {{ }}",
                    camera.example));
    std::vector<SampleRequest> requests;
    for (uint32_t i = 0; i < 64; ++i) {
      const Vec2 point{static_cast<float>(i % 8) / 4 - 1, static_cast<float>(i / 8) / 4 - 1};
      requests.push_back({i % 8, i / 8, 0, point, 0.25f});
    }
    const Spectrum kStale(7);
    std::vector<Spectrum> radiance(requests.size(), kStale);
    std::vector<SampleLayers> layers(requests.size());
    for (SampleLayers& each : layers) each.albedo = {7, 7, 7};
    const auto integrator = Create(GetParam(), *scene);
    const auto workspace = integrator->MakeWorkspace();
    integrator->Trace(requests, workspace.get(),
                      {radiance, GetParam().has_layers ? layers : std::span<SampleLayers>()});
    uint64_t seen = 0;
    for (size_t i = 0; i < requests.size(); ++i) {
      const Ray ray = scene->camera().GenerateRay(requests[i].image_point, {0.5f, 0.5f});
      const bool sees_nothing = ray.direction == Vec3();
      EXPECT_EQ(radiance[i].ToRgb(), sees_nothing ? Rgb() : (Rgb{0.25f, 0.5f, 0.75f})) << i;
      if (GetParam().has_layers) {
        EXPECT_EQ(layers[i].albedo, Rgb()) << i;
      }
      seen += sees_nothing ? 0 : 1;
    }
    EXPECT_EQ(workspace->rays.camera, seen);
    EXPECT_EQ(seen < requests.size(), camera.name == "fisheye");
  }
}

class EveryIntegratorWithLightGroups : public testing::TestWithParam<IntegratorEntry> {};

INSTANTIATE_TEST_SUITE_P(Registry, EveryIntegratorWithLightGroups,
                         testing::ValuesIn(RowsWhere(&IntegratorEntry::has_light_groups)), RowName);

// The others say that they do not tell groups apart; then nobody asks them.
TEST_P(EveryIntegratorWithLightGroups, GroupsOfLightsAreTogetherAllLight) {
  const auto scene = CompileText(
      std::string(kCamera) +
      "Background { color 0.2 0.3 0.5 group sky }\n"
      "Materials { Material { type diffuse albedo 0.8 0.6 0.4 }\n"
      "  Material { type dielectric ior 1.5 absorption 0.1 0.2 0.3 } }\n"
      "Scene {\n"
      "Node { Component<Object> { type plane normal 0 1 0 offset -1 }\n"
      "  Component<Material> { index 0 } }\n"
      "Node { Transform { translate 0 0 -4 } Component<Object> { type sphere radius 1 }\n"
      "  Component<Material> { index 1 } }\n"
      "Node { Transform { translate -2 1 -4 } Component<Object> { type sphere radius 0.5 }\n"
      "  Component<Material> { index 0 } Component<Light> { type area radiance 5 4 3 } }\n"
      "Node { Component<Light> { type directional direction 0 -1 -1 angle 5 group sun } } }");
  const size_t groups = scene->light_groups().size();
  ASSERT_EQ(groups, 3u);
  std::vector<SampleRequest> requests;
  for (uint32_t i = 0; i < 3000; ++i) {  // More than are followed together.
    const Vec2 point{static_cast<float>(i % 50) / 25 - 1, static_cast<float>(i / 50) / 30 - 1};
    requests.push_back({i % 50, i / 50, 0, point, 0.04f});
  }
  std::vector<Spectrum> radiance(requests.size()), plain(requests.size());
  std::vector<Rgb> light(groups * requests.size(), Rgb{7, 7, 7});
  const auto integrator = Create(GetParam(), *scene);
  const auto workspace = integrator->MakeWorkspace();
  integrator->Trace(requests, workspace.get(), {plain});
  SampleOutput output{radiance};
  output.group_light = light;
  output.group_count = groups;
  integrator->Trace(requests, workspace.get(), output);
  EXPECT_TRUE(radiance == plain);
  for (size_t i = 0; i < requests.size(); ++i) {
    const Rgb sum = light[3 * i] + light[3 * i + 1] + light[3 * i + 2];
    const Rgb all = radiance[i].ToRgb();
    for (int c = 0; c < 3; ++c) ASSERT_NEAR(sum[c], all[c], 2e-6f * (1 + all[c])) << i;
  }
}

/// Spheres on a floor, a lamp, a light: something for every integrator.
std::unique_ptr<const Scene> StillLife() {
  std::string spheres;
  for (int i = 0; i < 9; ++i) {
    spheres += "Node { Transform { translate " + std::to_string(i % 3 * 2 - 2) + " -0.5 " +
               std::to_string(-4 - i / 3 * 2) +
               " scale 0.8 0.5 0.8 } Component<Object> { type sphere radius 1 } "
               "Component<Material> { index 0 } }\n";
  }
  return CompileText(
      std::string(kCamera) +
      "Background { color 0.2 0.3 0.5 ambient_light 0.1 0.1 0.1 }\n"
      "Materials { Material { type diffuse albedo 0.8 0.6 0.4 } }\n"
      "Scene { " +
      spheres +
      "Node { Transform { translate 0 -1 -5 x_rotate -90 } "
      "Component<Object> { type rectangle width 30 height 30 } Component<Material> { index 0 } }\n"
      "Node { Transform { translate 0 3 -5 } Component<Object> { type sphere radius 0.5 } "
      "Component<Material> { index 0 } Component<Light> { type area radiance 4 3 2 } }\n"
      "Node { Transform { translate 3 4 0 } Component<Light> { type point attenuation 0.1 } } }");
}

TEST_P(EveryIntegrator, ASampleDoesNotDependOnTheOthersOfItsList) {
  const auto scene = StillLife();
  const auto integrator = Create(GetParam(), *scene);
  std::vector<SampleRequest> requests;
  for (uint32_t i = 0; i < 500; ++i) {
    const auto position = static_cast<float>(i) / 250;
    requests.push_back({i % 20, i / 20, i % 3, {position - 1, 0.5f - position / 2}});
  }
  std::vector<Spectrum> together(requests.size());
  const auto workspace = integrator->MakeWorkspace();
  integrator->Trace(requests, workspace.get(), {together});

  std::reverse(requests.begin(), requests.end());
  for (size_t i = 0; i < requests.size(); ++i) {
    Spectrum alone;
    integrator->Trace({&requests[i], 1}, integrator->MakeWorkspace().get(), {{&alone, 1}});
    EXPECT_EQ(alone, together[requests.size() - 1 - i]);
  }
}

std::vector<float> Render(const Integrator& integrator, int threads) {
  const ThreadLimit limit(threads);
  EXPECT_EQ(ThreadCount(), threads);
  RenderOptions options;
  options.width = 48;
  options.height = 32;
  options.crop = {0, 0, 48, 32};
  options.pattern = SamplePattern::kFilter;
  options.samples = 4;
  options.tile_size = 8;
  RenderJob job(integrator, options);
  EXPECT_TRUE(job.Run(CancelToken()).ok());
  EXPECT_EQ(job.Dropped().Count(), 0u);
  std::vector<float> values;
  for (int y = 0; y < options.height; ++y) {
    values.insert(values.end(), job.film().Row(y).begin(), job.film().Row(y).end());
  }
  return values;
}

TEST_P(EveryIntegrator, GivesTheSameBitsForAnyNumberOfThreads) {
  const auto scene = StillLife();
  const auto integrator = Create(GetParam(), *scene);
  const std::vector<float> alone = Render(*integrator, 1);
  EXPECT_NE(alone.front(), alone[alone.size() * 3 / 4]) << "the picture shows nothing";
  EXPECT_EQ(Render(*integrator, 2), alone);
  EXPECT_EQ(Render(*integrator, 7), alone);
}

class EveryPhysicalIntegrator : public testing::TestWithParam<IntegratorEntry> {};

INSTANTIATE_TEST_SUITE_P(Registry, EveryPhysicalIntegrator,
                         testing::ValuesIn(RowsWhere(&IntegratorEntry::is_physical)), RowName);

// P4: where everything reflects all light and the sky is 1, nothing can be seen: every pixel is 1.
TEST_P(EveryPhysicalIntegrator, NothingIsVisibleInAFurnace) {
  const auto scene = CompileText(
      std::string(kCamera) +
      "Background { color 1 1 1 ambient_light 0 0 0 }\n"
      "Materials { Material { type diffuse albedo 1 1 1 } }\n"
      "Scene { Node { Transform { translate 0 0 -3 } Component<Object> { type sphere radius 1 } "
      "Component<Material> { index 0 } }\n"
      "Node { Transform { translate 1.5 0 -2.5 scale 0.5 2 0.5 } "
      "Component<Object> { type sphere radius 1 } Component<Material> { index 0 } }\n"
      "Node { Transform { translate 0 -1 -3 x_rotate -90 } "
      "Component<Object> { type rectangle width 3 height 2 } Component<Material> { index 0 } } }");
  constexpr int kSide = 6;
  constexpr uint32_t kRuns = 32;
  std::vector<double> sums(kSide * kSide), squares(kSide * kSide);
  double sum = 0, sum_of_squares = 0;
  for (uint32_t run = 0; run < kRuns; ++run) {
    IntegratorOptions light;
    light.seed = run;
    const auto integrator = GetParam().create(*scene, light);
    ASSERT_TRUE(integrator.ok());
    RenderOptions options;
    options.width = options.height = kSide;
    options.crop = {0, 0, kSide, kSide};
    options.grid = PixelGrid::kCentres;
    options.pattern = SamplePattern::kFilter;
    options.samples = (*integrator)->TracesLightPaths() ? 2048 : 256;
    options.seed = run;
    RenderJob job(**integrator, options);
    ASSERT_TRUE(job.Run(CancelToken()).ok());
    double mean = 0;
    for (int i = 0; i < kSide * kSide; ++i) {
      const auto red = static_cast<double>(job.film().Pixel(i % kSide, i / kSide).x);
      sums[static_cast<size_t>(i)] += red;
      squares[static_cast<size_t>(i)] += red * red;
      mean += red / (kSide * kSide);
    }
    sum += mean;
    sum_of_squares += mean * mean;
  }
  const auto expect_one = [](double values, double their_squares, double strength) {
    const double mean = values / kRuns;
    const double variance = std::max(0.0, their_squares / kRuns - mean * mean) / (kRuns - 1);
    EXPECT_NEAR(mean, 1, test::kLargestDeviate * std::sqrt(variance) + 1e-5);
    EXPECT_LE(std::sqrt(variance), strength);
  };
  expect_one(sum, sum_of_squares, 0.002);
  for (size_t i = 0; i < sums.size(); ++i) {
    SCOPED_TRACE(i);
    expect_one(sums[i], squares[i], 0.015);
  }
}

}  // namespace
}  // namespace candela
