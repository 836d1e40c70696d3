// Straight lines through solids, evenly spread over all places and directions: Cauchy's and
// Crofton's formulas give volume and surface by what a scene says of entries and exits. Santalo,
// "Integral Geometry and Geometric Probability", 1976.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "math/elementary.h"
#include "sampling/sampler.h"
#include "scene/compile_scene.h"
#include "tests/kernel/test_mesh.h"
#include "tests/support/compile_text.h"
#include "tests/support/estimate.h"
#include "tests/support/lines.h"

namespace candela {
namespace {

using test::TestMesh;
using testing_support::CompileText;
using testing_support::Crossings;
using testing_support::Estimate;
using testing_support::ExpectEstimate;
using testing_support::FollowLine;
using testing_support::kCamera;
using testing_support::LineThroughBall;

constexpr uint32_t kRuns = 32;
constexpr uint32_t kLines = 16384;  // Of a run; four times as many where the ball around the solid
                                    // is mostly empty.

/// What lines say of a solid.
struct Measures {
  Estimate volume, surface, mean_chord;
  int odd_lines = 0;  ///< Whose entries and exits do not alternate.
};

Estimate OfRuns(const std::vector<double>& runs) {
  double sum = 0, squares = 0;
  for (const double value : runs) sum += value;
  const double mean = sum / static_cast<double>(runs.size());
  for (const double value : runs) squares += (value - mean) * (value - mean);
  const auto count = static_cast<double>(runs.size());
  return {mean, std::sqrt(squares / (count * (count - 1)))};
}

Measures Measure(const Scene& scene, uint32_t lines = kLines) {
  const Bounds3 box = scene.Bounds();
  const float radius = Length(box.Extent()) / 2 * 1.001f;
  const double disk = kPi * static_cast<double>(radius) * static_cast<double>(radius);
  std::vector<double> volumes, surfaces, chords;
  Measures measures;
  for (uint32_t run = 0; run < kRuns; ++run) {
    double inside = 0, crossings = 0, met = 0;
    for (uint32_t i = 0; i < lines; ++i) {
      const Sampler sampler(2, run, 0, i);
      const Ray ray = LineThroughBall(box.Center(), radius, sampler.Get2D(0), sampler.Get2D(2));
      const Crossings line = FollowLine(scene, ray.origin, ray.direction);
      if (!line.alternates) {
        ++measures.odd_lines;
        continue;
      }
      inside += line.inside;
      crossings += line.count;
      met += line.count > 0;
    }
    // Of lines in all directions: V is the mean length inside, S / 2 the mean number of crossings,
    // both times the area that the lines go through.
    volumes.push_back(disk * inside / lines);
    surfaces.push_back(2 * disk * crossings / lines);
    chords.push_back(inside / met);
  }
  measures.volume = OfRuns(volumes);
  measures.surface = OfRuns(surfaces);
  measures.mean_chord = OfRuns(chords);
  return measures;
}

/// A mesh in the place of a node.
std::unique_ptr<const Scene> SceneOf(const TestMesh& mesh, const std::vector<Mat4>& places) {
  auto shape = std::make_shared<MeshSpec>();
  shape->positions = mesh.positions;
  shape->triangles = mesh.triangles;
  SceneSpec spec;
  spec.materials.push_back({TypedSpec{"phong", {}, {}}, {}, {}});
  spec.meshes["mesh"] = std::move(shape);
  for (const Mat4& place : places) {
    NodeSpec node;
    node.parent_from_node = place;
    node.object = TypedSpec{"mesh", {}, {{{"obj_file", {}, {{"mesh", {}}}}}}};
    node.material = MaterialReference{{}, 0, {}};
    spec.nodes.push_back(node);
  }
  Diagnostics diagnostics;
  auto scene = CompileScene(spec, &diagnostics);
  EXPECT_TRUE(diagnostics.Lines().empty());
  return scene;
}

/// The mesh with its normals on the other side.
TestMesh TurnedInsideOut(TestMesh mesh) {
  for (auto& [a, b, c] : mesh.triangles) std::swap(b, c);
  return mesh;
}

/// Volume and surface of a closed mesh by its triangles.
std::pair<double, double> VolumeAndSurface(const TestMesh& mesh) {
  double volume = 0, surface = 0;
  for (const auto& [i, j, k] : mesh.triangles) {
    const Vec3d a = ToDouble(mesh.positions[i]), b = ToDouble(mesh.positions[j]),
                c = ToDouble(mesh.positions[k]);
    volume += Dot(a, Cross(b, c)) / 6;
    surface += Length(Cross(b - a, c - a)) / 2;
  }
  return {volume, surface};
}

void ExpectSolid(const Scene& scene, double volume, double surface, bool is_convex = true) {
  const Measures measures = Measure(scene, 4 * kLines);
  // A line may meet an edge, where in and out fall together.
  EXPECT_LE(measures.odd_lines, 5);
  ExpectEstimate(measures.volume, volume);
  ExpectEstimate(measures.surface, surface);
  if (is_convex) ExpectEstimate(measures.mean_chord, 4 * volume / surface);
}

std::unique_ptr<const Scene> Ball(const char* transform, double radius) {
  return CompileText(fmt::format(
      "{}Materials {{ Material {{ }} }} Scene {{ Transform {{ {} }} "
      "Component<Object> {{ type sphere radius {} }} Component<Material> {{ index 0 }} }}",
      kCamera, transform, radius));
}

// P13, CF37: 4/3.
TEST(MeanChord, OfASphereIsFourThirdsOfItsRadius) {
  ExpectSolid(*Ball("", 1), 4 * kPi / 3, 4 * kPi);
  ExpectEstimate(Measure(*Ball("translate 3 -5 2 x_rotate 30", 2)).mean_chord, 2.666667);
}

// P13: a ball that is stretched to twice its length; its surface is that of a prolate spheroid.
TEST(MeanChord, OfAStretchedBallIsFourVolumesOverItsSurface) {
  const double e = std::sqrt(0.75);
  const double surface = 2 * kPi * (1 + 2 / e * std::asin(e));
  ExpectSolid(*Ball("y_rotate 40 scale 1 1 2", 1), 8 * kPi / 3, surface);
}

// P13, CF37: 2/3.
TEST(MeanChord, OfAUnitCubeIsTwoThirds) {
  ExpectSolid(*SceneOf(test::BoxMesh({0, 0, 0}, {1, 1, 1}), {Mat4::Identity()}), 1, 6);
}

// P13: a box without a right angle to the axes, far from the origin.
TEST(MeanChord, OfALongBoxIsFourVolumesOverItsSurface) {
  const Mat4 place = Mat4::Translate({10, -20, 5}) * Mat4::Rotate(0, 33) * Mat4::Rotate(2, 21);
  ExpectSolid(*SceneOf(test::BoxMesh({0, 0, 0}, {1, 2, 3}), {place}), 6, 22);
}

// P13
TEST(MeanChord, OfAGlobeOfTrianglesIsFourVolumesOverItsSurface) {
  const TestMesh globe = TurnedInsideOut(test::Globe(20, 40));
  const auto [volume, surface] = VolumeAndSurface(globe);
  ExpectSolid(*SceneOf(globe, {Mat4::Identity()}), volume, surface);
}

// P13: with valleys, which lines leave and enter again.
TEST(LinesThroughSolids, FindVolumeAndSurfaceOfAStar) {
  const TestMesh star = TurnedInsideOut(test::Star(24, 48, 5));
  const auto [volume, surface] = VolumeAndSurface(star);
  ExpectSolid(*SceneOf(star, {Mat4::Identity()}), volume, surface, false);
}

// P13: of two instances, of which one is mirrored and smaller, the sums.
TEST(LinesThroughSolids, FindVolumeAndSurfaceOfInstances) {
  const TestMesh globe = TurnedInsideOut(test::Globe(20, 40));
  const auto [volume, surface] = VolumeAndSurface(globe);
  const Mat4 left = Mat4::Translate({-1, 0, 0}) * Mat4::Rotate(1, 20);
  const Mat4 right = Mat4::Translate({1, 0.5, 0}) * Mat4::Scale({-0.8, 0.8, 0.8});
  const auto scene = SceneOf(globe, {left, right});
  ASSERT_TRUE(scene->objects()[0].is_instance);
  ExpectSolid(*scene, volume * (1 + 0.512), surface * (1 + 0.64), false);
}

}  // namespace
}  // namespace candela
