// The integrators that show a part of the light, or none: direct, ambient_occlusion, debug.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <set>
#include <string>
#include <tuple>

#include "integrators/registry.h"
#include "tests/support/compile_text.h"
#include "tests/support/estimate.h"

namespace candela {
namespace {

using testing_support::CompileText;
using testing_support::EstimateRadiance;
using testing_support::ExpectEstimate;
using testing_support::kCamera;

std::unique_ptr<Integrator> Make(const char* name, const Scene& scene,
                                 const IntegratorOptions& options = {}) {
  auto created = CreateIntegrator(name, scene, options);
  EXPECT_TRUE(created.ok()) << (created ? "" : created.error().message);
  return created ? *std::move(created) : nullptr;
}

/// A closed room that emits and reflects 1/2.
std::string Room() {
  return std::string(kCamera) +
         "Materials { Material { type diffuse albedo 0.5 0.5 0.5 } }\n"
         "Scene { Component<Object> { type sphere radius 1 } Component<Material> { index 0 }\n"
         "Component<Light> { type area radiance 0.5 0.5 0.5 } }";
}

// CF1 with one reflection: Le (1 - a^2) / (1 - a).
TEST(Direct, IsOneReflectionOfWhatShines) {
  const auto scene = CompileText(Room());
  IntegratorOptions options;
  for (const std::optional<uint32_t> bounces : {std::optional<uint32_t>(), {0}, {9}}) {
    options.bounces = bounces;
    ExpectEstimate(EstimateRadiance(*Make("direct", *scene, options), {0, 0}, 64, 64), 0.75);
  }
}

TEST(Direct, DoesNotKnowPhongHighlights) {
  const auto scene = CompileText(
      std::string(kCamera) +
      "Materials { Material { diffuse 1 1 1 specular 1 1 1 shininess 9 } }\n"
      "Scene { Component<Object> { type sphere radius 1 } Component<Material> { index 0 } }");
  const auto created = CreateIntegrator("direct", *scene, {});
  ASSERT_FALSE(created.ok());
  EXPECT_THAT(created.error().message, testing::HasSubstr("the integrator 'direct'"));
}

/// A floor at -4 that is looked at along its normal, and above the point in the middle a disk of
/// radius 1 at a distance of 1, on the axis of the view, which sees past it through a ring.
std::string FloorUnderADisk(const char* material = "") {
  return fmt::format(
      "Camera {{ center 0 -3.5 -3.5 direction 0 0 -1 up 0 1 0 fov 90 }}\n"
      "Background {{ color 0.25 0.5 0.75 ambient_light 0 0 0 }}\n"
      "Materials {{ Material {{ name paper type diffuse }} {} }}\n"
      "Scene {{ Node {{ Transform {{ translate 0 -4 -4 x_rotate -90 }} "
      "Component<Object> {{ type rectangle width 100 height 100 }} "
      "Component<Material> {{ index 0 }} }}\n"
      "Node {{ Transform {{ translate 0 -3 -4 x_rotate -90 }} "
      "Component<Object> {{ type disk radius 1 }} Component<Material> {{ index {} }} }} }}",
      material, material[0] ? 1 : 0);
}

// The camera is half a unit above the floor and before the disk's axis, and sees the point below
// its middle at 45 degrees down.
constexpr Vec2 kMiddle{0, -1};

// CF12, or Lambert's disk: it covers r^2 / (r^2 + h^2) of the sky, weighed by the cosine.
TEST(AmbientOcclusion, UnderADiskIsWhatItLeavesOfTheSky) {
  const auto scene = CompileText(FloorUnderADisk());
  ExpectEstimate(EstimateRadiance(*Make("ambient_occlusion", *scene), kMiddle, 256, 1024), 0.5);
}

TEST(AmbientOcclusion, CountsWhatIsNearAlone) {
  const auto scene = CompileText(FloorUnderADisk());
  IntegratorOptions options;
  options.ao_distance = 0.99f;
  const auto near = EstimateRadiance(*Make("ambient_occlusion", *scene, options), kMiddle, 16, 64);
  EXPECT_EQ(near.mean, 1);
  options.ao_distance = 2;
  ExpectEstimate(EstimateRadiance(*Make("ambient_occlusion", *scene, options), kMiddle, 256, 1024),
                 0.5);
}

// The disk lets half of the light through.
TEST(AmbientOcclusion, SeesThroughHoles) {
  const auto scene =
      CompileText(FloorUnderADisk("Material { type mask material paper opacity 0.5 }"));
  ExpectEstimate(EstimateRadiance(*Make("ambient_occlusion", *scene), kMiddle, 256, 1024), 0.75);
}

/// What a view shows at a point of the picture.
Rgb Shown(const Scene& scene, DebugView view, Vec2 image_point, RayCounts* rays = nullptr) {
  IntegratorOptions options;
  options.view = view;
  options.bounces = 3;
  options.shadows = true;
  const auto integrator = Make("debug", scene, options);
  const auto workspace = integrator->MakeWorkspace();
  const SampleRequest request{0, 0, 0, image_point};
  Spectrum radiance;
  integrator->Trace({&request, 1}, workspace.get(), {{&radiance, 1}});
  if (rays) *rays = workspace->rays;
  return radiance.ToRgb();
}

/// A wall that is looked at head-on from a distance of 2, and a sphere beside the view.
std::string Wall(const char* material) {
  return fmt::format(
      "{}Background {{ color 0.25 0.5 0.75 ambient_light 0 0 0 }}\n"
      "Materials {{ Material {{ {} }} Material {{ type diffuse albedo 0 1 0 }} }}\n"
      "Scene {{ Node {{ Transform {{ translate 0 0 -2 }} "
      "Component<Object> {{ type rectangle width 1 height 1 }} "
      "Component<Material> {{ index 0 }} }}\n"
      "Node {{ Transform {{ translate 1.5 0 -2 }} "
      "Component<Object> {{ type sphere radius 0.25 }} Component<Material> {{ index 1 }} }} }}",
      kCamera, material);
}

TEST(DebugViews, ShowTheSurface) {
  const auto scene = CompileText(Wall("type diffuse albedo 0.25 0.5 0.75"));
  EXPECT_EQ(Shown(*scene, DebugView::kNormal, {0, 0}), (Rgb{0.5f, 0.5f, 1}));
  EXPECT_EQ(Shown(*scene, DebugView::kGeometricNormal, {0, 0}), (Rgb{0.5f, 0.5f, 1}));
  EXPECT_EQ(Shown(*scene, DebugView::kAlbedo, {0, 0}), (Rgb{0.25f, 0.5f, 0.75f}));
  const Rgb uv = Shown(*scene, DebugView::kUv, {0.125f, -0.0625f});
  EXPECT_FLOAT_EQ(uv.x, 0.75f);
  EXPECT_FLOAT_EQ(uv.y, 0.375f);
  EXPECT_EQ(uv.z, 0);
  for (const DebugViewEntry& entry : DebugViews()) {
    if (entry.view == DebugView::kBounces || entry.view == DebugView::kCost) continue;
    EXPECT_EQ(Shown(*scene, entry.view, {-0.9f, 0.9f}), (Rgb{0.25f, 0.5f, 0.75f})) << entry.name;
  }
}

TEST(DebugViews, GiveEachNumberAColor) {
  const auto scene = CompileText(Wall("type diffuse"));
  for (const DebugView view : {DebugView::kObjectId, DebugView::kMaterialId}) {
    EXPECT_NE(Shown(*scene, view, {0, 0}), Shown(*scene, view, {0.7f, 0}));
    EXPECT_EQ(Shown(*scene, view, {0, 0}), Shown(*scene, view, {0.1f, 0.1f}));
  }
}

// Half a box of 2.25 x 1 x 0.5 away it would be half as bright as it can be.
TEST(DebugViews, ShowWhatIsNearBrighter) {
  const auto scene = CompileText(Wall("type diffuse"));
  const float wall = Shown(*scene, DebugView::kDepth, {0, 0}).x;
  EXPECT_GT(wall, 0.3f);
  EXPECT_LT(wall, 0.5f);
  EXPECT_GT(Shown(*scene, DebugView::kDepth, {0.75f, 0}).x, wall);
}

TEST(DebugViews, ShowWhatASampleTakes) {
  const auto matt = CompileText(Wall("diffuse 1 1 1"));
  const auto mirror = CompileText(Wall("diffuse 0 0 0 specular 1 1 1 shininess 9"));
  // Where nothing is, there is the camera's ray alone, which does not go on.
  RayCounts rays;
  EXPECT_EQ(Shown(*matt, DebugView::kBounces, {-0.9f, 0.9f}, &rays), Rgb());
  EXPECT_EQ(rays.Total(), 1u);
  const Rgb one_ray = Shown(*matt, DebugView::kCost, {-0.9f, 0.9f});
  EXPECT_GT(one_ray.z, 0);
  EXPECT_EQ(one_ray.x, 0);
  // A mirror that the path integrator does not know is followed as the course does.
  EXPECT_NE(Shown(*mirror, DebugView::kBounces, {0, 0}, &rays), Rgb());
  EXPECT_EQ(rays.reflection, 1u);
  EXPECT_EQ(rays.Total(), 2u);
  EXPECT_EQ(Shown(*mirror, DebugView::kCost, {0, 0}), Shown(*mirror, DebugView::kCost, {0.1f, 0}));
}

TEST(DebugViews, HaveNamesByWhichTheyAreFound) {
  for (const DebugViewEntry& entry : DebugViews()) {
    ASSERT_NE(FindDebugView(entry.name), nullptr);
    EXPECT_EQ(FindDebugView(entry.name)->view, entry.view);
    EXPECT_FALSE(entry.description.empty());
  }
  EXPECT_EQ(FindDebugView("normals"), nullptr);
}

// Of two lamps one is behind the wall, where no ray is sent to: chosen by effect it never is.
TEST(DebugViews, ShowTheEffortOfTheWayInWhichLightsAreChosen) {
  const auto scene = CompileText(
      std::string(kCamera) +
      "Materials { Material { type diffuse albedo 0.5 0.5 0.5 } } Scene {"
      "Node { Component<Object> { type plane normal 0 0 1 offset -2 } Component<Material> { index "
      "0 "
      "} } Node { Transform { translate 0 0 -1 } Component<Light> { type point attenuation 1 } } "
      "Node { Transform { translate 0 0 -9 } Component<Light> { type point attenuation 1 } } }");
  ASSERT_TRUE(scene);
  IntegratorOptions options;
  options.view = DebugView::kCost;
  options.bounces = 1;
  const auto effort = [&](LightChoice choice) {
    options.light_choice = choice;
    const auto integrator = Make("debug", *scene, options);
    const auto workspace = integrator->MakeWorkspace();
    float blue = 0;
    for (uint32_t i = 0; i < 64; ++i) {
      const SampleRequest request{0, 0, i, {0, 0}, 0};
      Spectrum radiance;
      integrator->Trace({&request, 1}, workspace.get(), {{&radiance, 1}});
      blue += radiance.ToRgb().z;
    }
    return blue;
  };
  EXPECT_NE(effort(LightChoice::kUniform), effort(LightChoice::kByEffect));
}

// Golden steps around the circle: no two of a hundred are the same.
TEST(DebugViews, ColorsOfManyObjectsDiffer) {
  std::string nodes;
  for (int i = 0; i < 100; ++i) {
    nodes += fmt::format(
        "Node {{ Transform {{ translate {} 0 -10 }} Component<Object> {{ type sphere radius 0.05 "
        "}} "
        "Component<Material> {{ index 0 }} }}\n",
        0.2 * i - 9.9);
  }
  const auto scene = CompileText(std::string(kCamera) +
                                 "Materials { Material { type diffuse } } Scene { " + nodes + " }");
  std::set<std::tuple<float, float, float>> colors;
  for (int i = 0; i < 100; ++i) {
    const float x = (0.2f * static_cast<float>(i) - 9.9f) / 10;
    const Rgb color = Shown(*scene, DebugView::kObjectId, {x, 0});
    colors.insert({color.x, color.y, color.z});
  }
  EXPECT_EQ(colors.size(), 100u);
}

}  // namespace
}  // namespace candela
