// How fast the noise of path tracing falls with the number of samples: the slope of log RMSE over
// log N. The slow set has more scenes and techniques.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <ostream>
#include <string>
#include <tuple>
#include <vector>

#include "integrators/path.h"
#include "integrators/registry.h"
#include "tests/support/compile_text.h"
#include "tests/support/effort.h"
#include "tests/support/estimate.h"

namespace candela {
namespace {

using testing_support::CompileText;
using testing_support::EstimateRadiance;
using testing_support::kIsSlow;

/// Pixels from whose means the RMSE is taken, at least: its own relative error is
/// 1 / sqrt(2 pixels), and that of the slope, which all seven numbers of samples share, 0.097 times
/// that.
constexpr uint32_t kPixels = 128;
/// Samples at least, whatever the pixels: few samples of a pixel cost little.
constexpr uint32_t kLeastSamples = 65536;

/// A way to choose the points of samples, and the slopes that it may have.
struct SamplerRow {
  const char* name;
  SamplerKind kind;
  double steepest, shallowest;  ///< In any scene.
  double under_a_rectangle;     ///< The shallowest in scenes that a rectangle lights.
};

constexpr double kAny = -std::numeric_limits<double>::infinity();

// A row for each kind of sampler.
constexpr SamplerRow kSamplers[] = {
    {"independent", SamplerKind::kIndependent, -0.53, -0.47, -0.47},
    {"sobol", SamplerKind::kSobol, kAny, -0.50, -0.70},
};

std::unique_ptr<const Integrator> PathWith(const Scene& scene, uint32_t bounces, SamplerKind kind,
                                           const PathTechniques& techniques) {
  IntegratorOptions options;
  options.bounces = bounces;
  options.seed = 11;
  options.sampler = kind;
  return std::make_unique<PathIntegrator>(scene, options, techniques);
}

/// The slope of the straight line through log RMSE over log N for N = 4, 16, ..., 4^7, by least
/// squares.
double SlopeOfNoise(const Integrator& integrator, Vec2 image_point, uint32_t least_pixels) {
  constexpr int kSteps = 7;
  double slope = 0, weights = 0;
  for (int k = 1; k <= kSteps; ++k) {
    const uint32_t samples = 1u << (2 * k);
    const uint32_t pixels = std::max(least_pixels, kLeastSamples / samples);
    const auto estimate = EstimateRadiance(integrator, image_point, pixels, samples);
    EXPECT_GT(estimate.error, 0) << "there is no noise to measure";
    const double log_rmse = std::log(estimate.error * std::sqrt(pixels));
    const double offset = (k - (kSteps + 1) / 2.0) * std::log(4.0);
    slope += offset * log_rmse;
    weights += offset * offset;
  }
  return slope / weights;
}

struct SceneRow {
  const char* name;
  uint32_t bounces;
  bool is_under_a_rectangle;  ///< Whose light comes directly: with one bounce.
  std::string text;
  uint32_t pixels = kPixels;
  double shallowest = kAny;  ///< Where that is more than its sampler says.
};

/// A floor z = 0 of the given material under lamps; the camera looks at the origin.
std::string Floor(const std::string& floor, const std::string& lamps,
                  const std::string& camera = "") {
  return fmt::format(
      "Camera {{ center 0 -4 1.5 direction 0 4 -1.5 up 0 0 1 fov 30 {} }}\n"
      "Materials {{ Material {{ {} }} Material {{ type diffuse albedo 0.5 0.5 0.5 }}\n"
      "Material {{ type dielectric ior 1.5 }} }}\n"
      "Scene {{ Node {{ Component<Material> {{ index 0 }}\n"
      "Component<Object> {{ type plane normal 0 0 1 offset 0 }} }}\n{} }}",
      camera, floor, lamps);
}

std::string Lamp(const std::string& shape, const std::string& place = "translate 0.3 0.2 1.5") {
  return fmt::format(
      "Node {{ Transform {{ {} }} Component<Object> {{ type {} }} Component<Material> {{ index 1 }}"
      " Component<Light> {{ type area radiance 4 4 4 }} }}\n",
      place, shape);
}

std::string Thing(const std::string& shape, const std::string& place, int material = 1) {
  return fmt::format(
      "Node {{ Transform {{ {} }} Component<Object> {{ type {} }} "
      "Component<Material> {{ index {} }} }}\n",
      place, shape, material);
}

std::vector<SceneRow> Scenes() {
  const std::string diffuse = "type diffuse albedo 0.6 0.6 0.6";
  const std::string rectangle = Lamp("rectangle width 1.5 height 1");
  std::vector<SceneRow> scenes = {
      {"FloorUnderARectangle", 1, true, Floor(diffuse, rectangle)},
      {"PenumbraOfARectangle", 1, true,
       Floor(diffuse, rectangle + Thing("rectangle width 1 height 3", "translate 0.6 0 0.7"))},
      {"FloorUnderADisk", 2, false, Floor(diffuse, Lamp("disk radius 0.8"))},
  };
  if (!kIsSlow) return scenes;
  const std::vector<SceneRow> more = {
      {"FloorUnderASphere", 2, false, Floor(diffuse, Lamp("sphere radius 0.5"))},
      {"FloorUnderATriangle", 2, false,
       Floor(diffuse, Lamp("triangle vertex0 -1 0 0 vertex1 1 0 0.4 vertex2 0 1 0"))},
      {"PlasticUnderARectangle", 1, true,
       Floor("type plastic albedo 0.5 0.5 0.5 roughness 0.4", rectangle)},
      {"MetalUnderARectangle", 1, true,
       Floor("type conductor metal gold roughness 0.5", rectangle)},
      {"FloorUnderTwoLamps", 2, false,
       Floor(diffuse, rectangle + Lamp("sphere radius 0.3", "translate -1 0 0.8"))},
      {"FloorUnderTheSky", 2, false,
       "Background { color 1 1 1 }\n" +
           Floor(diffuse, Thing("sphere radius 0.6", "translate 0.5 0.3 0.6"))},
      {"OutOfFocus", 2, false,
       Floor(diffuse, rectangle + Thing("sphere radius 0.3", "translate 0 -0.2 0.2"),
             "aperture 0.3 focus_distance 2"),
       8 * kPixels, -0.49},  // What depends on lens and light gains nothing: -0.5, by 4.7 errors.
      {"EdgeOfALampOutOfFocus", 0, false,
       Floor(diffuse, Lamp("sphere radius 0.3", "translate 0.3 0 0"),
             "aperture 0.3 focus_distance 2")},
  };
  scenes.insert(scenes.end(), more.begin(), more.end());
  return scenes;
}

struct TechniquesRow {
  const char* name;
  PathTechniques techniques;
};

std::vector<TechniquesRow> Techniques() {
  std::vector<TechniquesRow> all = {{"Usual", {}}};
  if (!kIsSlow) return all;
  PathTechniques others;
  others.weights = PathTechniques::Weights::kBalanceHeuristic;
  others.light_choice = LightChoice::kUniform;
  PathTechniques rays_alone;
  rays_alone.next_event = false;
  all.push_back({"OtherWeightsAndChoices", others});
  all.push_back({"RaysAlone", rays_alone});
  return all;
}

void PrintTo(const SceneRow& row, std::ostream* out) {
  *out << row.name;
}

void PrintTo(const TechniquesRow& row, std::ostream* out) {
  *out << row.name;
}

class NoiseOf : public testing::TestWithParam<std::tuple<SceneRow, TechniquesRow>> {};

INSTANTIATE_TEST_SUITE_P(
    Scenes, NoiseOf, testing::Combine(testing::ValuesIn(Scenes()), testing::ValuesIn(Techniques())),
    [](const auto& test) {
      return std::string(std::get<0>(test.param).name) + "_" + std::get<1>(test.param).name;
    });

// P10
TEST_P(NoiseOf, FallsWithTheSamplesAsItsSamplerPromises) {
  const auto& [scene_row, techniques] = GetParam();
  const auto scene = CompileText(scene_row.text);
  for (const SamplerRow& row : kSamplers) {
    const auto path = PathWith(*scene, scene_row.bounces, row.kind, techniques.techniques);
    const double slope = SlopeOfNoise(*path, {0.02f, 0.03f}, scene_row.pixels);
    RecordProperty(row.name, fmt::format("{:.3f}", slope));
    EXPECT_GE(slope, row.steepest) << row.name;
    const double shallowest =
        scene_row.is_under_a_rectangle ? row.under_a_rectangle : row.shallowest;
    EXPECT_LE(slope, std::max(shallowest, scene_row.shallowest)) << row.name;
  }
}

}  // namespace
}  // namespace candela
