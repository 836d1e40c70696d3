// Integrators that solve the same transport see the same light: path tracing, path tracing by rays
// alone, and light tracing, over 40 scenes; in the mean of the picture and of its quarters.

#include "tests/integrators/same_light_scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "integrators/light_trace.h"
#include "integrators/path.h"
#include "integrators/registry.h"
#include "render/render_job.h"
#include "tests/support/compile_text.h"
#include "tests/support/effort.h"

namespace candela::same_light {
namespace {

using testing_support::kIsSanitized;
using testing_support::kIsSlow;

constexpr int kBlock = 8, kBlocksPerSide = 2;
constexpr int kSide = kBlock * kBlocksPerSide;
constexpr size_t kBlocks = kBlocksPerSide * kBlocksPerSide;

// The picture's mean is known to this part of it, so that no comparison passes by being noisy.
constexpr double kStrength = kIsSlow ? 1.1e-3 : kIsSanitized ? 3e-2 : 4.5e-3;
constexpr int kRuns = 16;

// 40 scenes, 3 pairs of integrators, 5 means: by Bonferroni each may fail by chance in 2.6e-6,
// all of them together in 1.6e-3.
constexpr double kLargestDeviate = 4.70;

/// Runs of one integrator that do not depend on each other: of each block, and of the whole
/// picture, the mean over its pixels and colours.
struct Runs {
  std::array<std::array<double, kRuns>, kBlocks + 1> means{};
};

struct Moments {
  double mean = 0;
  double variance = 0;  ///< Of the mean.
};

Moments MomentsOf(const std::array<double, kRuns>& values) {
  Moments moments;
  for (const double value : values) moments.mean += value / kRuns;
  for (const double value : values) {
    moments.variance += (value - moments.mean) * (value - moments.mean) / (kRuns * (kRuns - 1));
  }
  return moments;
}

/// Of two means the statistic t after Welch (1947), as a normal deviate: by Wallace (1959) from the
/// distribution of Student for the degrees of freedom that the variances give.
double WelchDeviate(const Moments& a, const Moments& b) {
  const double variance = a.variance + b.variance;
  if (variance == 0) return a.mean == b.mean ? 0 : INFINITY;
  const double t2 = (a.mean - b.mean) * (a.mean - b.mean) / variance;
  const double freedom =
      variance * variance * (kRuns - 1) / (a.variance * a.variance + b.variance * b.variance);
  return (8 * freedom + 1) / (8 * freedom + 3) * std::sqrt(freedom * std::log1p(t2 / freedom));
}

template <class MakeIntegrator>
Runs Render(uint32_t first_seed, uint32_t samples, MakeIntegrator make) {
  Runs runs;
  for (int run = 0; run < kRuns; ++run) {
    const uint32_t seed = first_seed + static_cast<uint32_t>(run);
    IntegratorOptions light;
    light.bounces = 8;
    light.seed = seed;
    const std::unique_ptr<Integrator> integrator = make(light);
    RenderOptions options;
    options.width = options.height = kSide;
    options.crop = {0, 0, kSide, kSide};
    options.grid = PixelGrid::kCentres;
    options.pattern = SamplePattern::kFilter;
    options.samples = samples;
    options.seed = seed;
    RenderJob job(*integrator, options);
    EXPECT_TRUE(job.Run(CancelToken()).ok());
    EXPECT_EQ(job.Dropped().Count() + job.DroppedSplats(), 0u);
    for (int y = 0; y < kSide; ++y) {
      for (int x = 0; x < kSide; ++x) {
        const Rgb colour = job.film().Pixel(x, y);
        const double mean = (static_cast<double>(colour.x) + static_cast<double>(colour.y) +
                             static_cast<double>(colour.z)) /
                            3;
        const auto block = static_cast<size_t>(y / kBlock * kBlocksPerSide + x / kBlock);
        runs.means[block][static_cast<size_t>(run)] += mean / (kBlock * kBlock);
        runs.means[kBlocks][static_cast<size_t>(run)] += mean / (kSide * kSide);
      }
    }
  }
  return runs;
}

double RelativeError(const Moments& moments) {
  return std::sqrt(moments.variance) / moments.mean;
}

/// With as many samples as it takes to the strength of the test: that differs by thousands of times
/// over scenes and integrators. Those of an attempt that was too noisy are forgotten. What is
/// black, or too noisy for any number of samples, is left to `ExpectPrecise`.
template <class MakeIntegrator>
Runs RenderPrecisely(uint32_t first_seed, MakeIntegrator make) {
  constexpr double kMostSamples = 1 << 22;
  double samples = kIsSanitized ? 1 : 4;
  for (;; first_seed += kRuns) {
    const Runs runs = Render(first_seed, static_cast<uint32_t>(samples), make);
    const Moments moments = MomentsOf(runs.means[kBlocks]);
    if (!(moments.mean > 0) || samples >= kMostSamples) return runs;
    const double too_large = RelativeError(moments) / kStrength;
    if (too_large < 1) return runs;
    samples *= std::clamp(1.3 * too_large * too_large, 1.3, 64.0);
    samples = std::min(std::ceil(samples), kMostSamples);
  }
}

void ExpectSame(const Runs& a, const Runs& b) {
  for (size_t i = 0; i <= kBlocks; ++i) {
    const Moments of_a = MomentsOf(a.means[i]), of_b = MomentsOf(b.means[i]);
    EXPECT_LT(WelchDeviate(of_a, of_b), kLargestDeviate)
        << (i < kBlocks ? "block " + std::to_string(i) : "the picture") << ": " << of_a.mean
        << " +- " << std::sqrt(of_a.variance) << " and " << of_b.mean << " +- "
        << std::sqrt(of_b.variance);
  }
}

void ExpectPrecise(const Runs& runs) {
  const Moments moments = MomentsOf(runs.means[kBlocks]);
  EXPECT_GT(moments.mean, 0.01) << "there is no light";
  EXPECT_LT(RelativeError(moments), kStrength);
}

PathTechniques Unlifted() {
  PathTechniques techniques;
  techniques.lift = false;
  return techniques;
}

class EveryScene : public testing::TestWithParam<NamedScene> {};

INSTANTIATE_TEST_SUITE_P(Light, EveryScene, testing::ValuesIn(Scenes()),
                         [](const auto& scene) { return scene.param.name; });

// P7: without lifted points, which light paths do not know.
TEST_P(EveryScene, LooksTheSameToEveryIntegrator) {
  const auto scene = testing_support::CompileText(GetParam().text);
  ASSERT_TRUE(scene);
  const Runs path = RenderPrecisely(1000, [&](const IntegratorOptions& options) {
    return std::make_unique<PathIntegrator>(*scene, options, Unlifted());
  });
  const Runs rays_alone = RenderPrecisely(2000, [&](const IntegratorOptions& options) {
    PathTechniques techniques = Unlifted();
    techniques.next_event = false;
    return std::make_unique<PathIntegrator>(*scene, options, techniques);
  });
  const Runs light_trace = RenderPrecisely(3000, [&](const IntegratorOptions& options) {
    auto created = LightTraceIntegrator::Create(*scene, options);
    EXPECT_TRUE(created.ok());
    return std::move(created).value();
  });
  for (const Runs* runs : {&path, &rays_alone, &light_trace}) ExpectPrecise(*runs);
  {
    SCOPED_TRACE("path, path by rays alone");
    ExpectSame(path, rays_alone);
  }
  {
    SCOPED_TRACE("path, light_trace");
    ExpectSame(path, light_trace);
  }
  {
    SCOPED_TRACE("path by rays alone, light_trace");
    ExpectSame(rays_alone, light_trace);
  }
}

TEST(Scenes, AreForty) {
  EXPECT_EQ(Scenes().size(), 40u);
}

TEST(WelchDeviate, IsThatOfStudentsT) {
  EXPECT_EQ(WelchDeviate({1, 0.01}, {1, 0.02}), 0);
  // t = 6 at 30 degrees of freedom: p = 1.4e-6, two-sided, which is 4.82 deviations.
  EXPECT_NEAR(WelchDeviate({0, 0.5}, {6, 0.5}), 4.82, 0.03);
}

}  // namespace
}  // namespace candela::same_light
