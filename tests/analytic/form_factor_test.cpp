// Form factors: the part of the light from one diffuse surface that reaches another, measured as
// the share of cosine-distributed rays from all over the first that hit the second.

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "math/frame.h"
#include "sampling/sampler.h"
#include "sampling/warp.h"
#include "tests/sampling/chi_square.h"
#include "tests/support/compile_text.h"

namespace candela {
namespace {

using testing_support::CompileText;
using testing_support::kCamera;

/// Rays start from a unit square or disk in z = 0 and go upwards.
enum class Start { kSquare, kDisk };

struct Share {
  double mean, error;
};

Share HitShare(const Scene& scene, Start start) {
  constexpr uint32_t kRuns = 32, kSamples = 131072;
  double sum = 0, squares = 0;
  for (uint32_t run = 0; run < kRuns; ++run) {
    uint32_t hits = 0;
    for (uint32_t i = 0; i < kSamples; ++i) {
      const Sampler sampler(1, run, 0, i);
      const Vec2 u = sampler.Get2D(0);
      const Vec2 p = start == Start::kDisk ? SampleDisk(u) : u - Vec2{0.5f, 0.5f};
      Ray ray({p.x, p.y, 0}, SampleCosineHemisphere(sampler.Get2D(2)));
      hits += scene.Occluded(ray);
    }
    const double mean = static_cast<double>(hits) / kSamples;
    sum += mean;
    squares += mean * mean;
  }
  const double mean = sum / kRuns;
  return {mean, std::sqrt(std::max(0.0, squares / kRuns - mean * mean) / (kRuns - 1))};
}

std::unique_ptr<const Scene> Facing(const std::string& node) {
  return CompileText(std::string(kCamera) + "Materials { Material { } } Scene { " + node +
                     " Component<Material> { index 0 } }");
}

void ExpectShare(const Scene& scene, Start start, double expected) {
  const Share share = HitShare(scene, start);
  EXPECT_LE(std::abs(share.mean - expected), test::kLargestDeviate * share.error);
  EXPECT_LE(share.error, 1e-3 * expected);
}

// CF12
TEST(FormFactor, OfParallelUnitSquaresAtDistanceOne) {
  ExpectShare(*Facing("Transform { translate 0 0 1 } "
                      "Component<Object> { type rectangle width 1 height 1 }"),
              Start::kSquare, 0.199825);
}

// CF12
TEST(FormFactor, OfUnitSquaresThatShareAnEdge) {
  ExpectShare(*Facing("Transform { translate 0.5 0 0.5 y_rotate 90 } "
                      "Component<Object> { type rectangle width 1 height 1 }"),
              Start::kSquare, 0.200044);
}

// CF12: r = h: (3 - sqrt 5) / 2.
TEST(FormFactor, OfCoaxialDisksAsFarAsTheyAreWide) {
  ExpectShare(*Facing("Transform { translate 0 0 1 } Component<Object> { type disk radius 1 }"),
              Start::kDisk, 0.381966);
}

// CF12: from one face of a cube everything arrives at the five others.
TEST(FormFactor, OfTheFacesOfACubeSumToOne) {
  const std::string face =
      "Component<Object> { type rectangle width 1 height 1 } "
      "Component<Material> { index 0 } }\n";
  std::string nodes = "Node { Transform { translate 0 0 1 } " + face;
  for (const char* turn : {"", "z_rotate 90", "z_rotate 180", "z_rotate 270"}) {
    nodes +=
        std::string("Node { Transform { ") + turn + " translate 0.5 0 0.5 y_rotate 90 } " + face;
  }
  const auto scene =
      CompileText(std::string(kCamera) + "Materials { Material { } } Scene { " + nodes + "}");
  EXPECT_NEAR(HitShare(*scene, Start::kSquare).mean, 1, 1e-5);
}

}  // namespace
}  // namespace candela
