// The floats of pictures have the same bits for every compiler, optimisation and machine: their
// hashes stand in a file. CANDELA_UPDATE=1 writes it.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <bit>
#include <span>
#include <string>

#include "base/files.h"
#include "driver/map_images.h"
#include "integrators/distribution.h"
#include "integrators/whitted.h"
#include "render/render_first_hits.h"
#include "tests/determinism/test_cases.h"
#include "tests/support/picture_check.h"
#include "tests/support/render_scene.h"

namespace candela::determinism {
namespace {

using testing_support::CourseScene;
using testing_support::RenderImage;
using testing_support::WholePicture;

// Tests run in the root of the project.
constexpr const char* kFile = "tests/determinism/hashes.txt";
constexpr int kWidth = 64, kHeight = 48;
constexpr uint32_t kRandomScenes = 10;

/// FNV-1a over the bits of all samples.
uint64_t HashOf(const Image& image) {
  uint64_t hash = 0xcbf29ce484222325;
  for (const float value : image.Samples()) {
    const auto bits = std::bit_cast<uint32_t>(value);
    for (int shift = 0; shift < 32; shift += 8) {
      hash = (hash ^ ((bits >> shift) & 0xff)) * 0x100000001b3;
    }
  }
  return hash;
}

std::string Line(const std::string& name, const Image& image) {
  return fmt::format("{:016x} {}\n", HashOf(image), name);
}

std::string LinesOfCourseScenes() {
  std::string lines;
  for (const CourseScene& course : testing_support::kCourseScenes) {
    const auto scene =
        testing_support::SceneOfFile(std::filesystem::path("assets/assignment4") / course.file);
    if (!scene) continue;
    const WhittedIntegrator integrator(*scene, course.bounces, course.shadows);
    lines += Line(course.file, RenderImage(integrator, WholePicture(kWidth, kHeight)));
  }
  return lines;
}

std::string LinesOfRandomScenes() {
  std::string lines;
  for (const char* integrator : {"whitted", "path", "light_trace"}) {
    for (uint32_t seed = 0; seed < kRandomScenes; ++seed) {
      const Subject subject = MakeSubject(integrator, seed);
      if (!subject.integrator) continue;
      const Placement strata{"strata", SamplePattern::kStrata, kStrataSamples};
      const Image image = RenderImage(*subject.integrator, OptionsFor(strata, kWidth, kHeight));
      lines += Line(fmt::format("{} {}", integrator, seed), image);
    }
  }
  return lines;
}

std::string LinesOfOtherIntegrators() {
  std::string lines;
  for (const char* integrator : {"direct", "ambient_occlusion", "debug"}) {
    for (uint32_t seed = 0; seed < kRandomScenes; ++seed) {
      const Subject subject = MakeMeshSubject(integrator, seed);
      if (!subject.integrator) continue;
      const RenderOptions options = WholePicture(kWidth, kHeight);
      lines += Line(fmt::format("meshes, {} {}", integrator, seed),
                    RenderImage(*subject.integrator, options));
    }
  }
  return lines;
}

std::string LinesOfMovingScenes() {
  std::string lines;
  for (const char* integrator :
       {"whitted", "path", "light_trace", "direct", "ambient_occlusion", "debug"}) {
    for (uint32_t seed = 0; seed < 3; ++seed) {
      const Subject subject = MakeMovingSubject(integrator, seed);
      if (!subject.integrator) continue;
      EXPECT_TRUE(subject.scene->IsMoving());
      const Placement strata{"strata", SamplePattern::kStrata, kStrataSamples};
      const Image image = RenderImage(*subject.integrator, OptionsFor(strata, kWidth, kHeight));
      lines += Line(fmt::format("moving, {} {}", integrator, seed), image);
    }
  }
  return lines;
}

std::string LinesOfMeshScenes() {
  std::string lines;
  for (const char* integrator : {"whitted", "path", "light_trace"}) {
    for (uint32_t seed = 0; seed < kRandomScenes; ++seed) {
      const Subject subject = MakeMeshSubject(integrator, seed);
      if (!subject.integrator) continue;
      const Placement strata{"strata", SamplePattern::kStrata, kStrataSamples};
      const Image image = RenderImage(*subject.integrator, OptionsFor(strata, kWidth, kHeight));
      lines += Line(fmt::format("meshes, {} {}", integrator, seed), image);
    }
  }
  return lines;
}

std::string LinesOfPlacements() {
  std::string lines;
  const Subject subject = MakeSubject("whitted", 0);
  if (!subject.integrator) return lines;
  for (const Placement& placement : AllPlacements()) {
    lines += Line(placement.name,
                  RenderImage(*subject.integrator, OptionsFor(placement, kWidth, kHeight)));
  }
  const RenderOptions options = WholePicture(kWidth, kHeight);
  const auto hits = RenderFirstHits(*subject.scene, options);
  lines += Line("normals", NormalImage(hits, options.crop, ImageFormat::kPfm));
  lines += Line("depth", DepthImage(hits, options.crop, {}, ImageFormat::kPfm));
  return lines;
}

std::string LinesOfDistribution() {
  std::string lines;
  for (uint32_t seed = 0; seed < kRandomScenes; ++seed) {
    const Subject subject = MakeMeshSubject("distribution", seed);
    if (!subject.integrator) continue;
    lines += Line(fmt::format("meshes, distribution {}", seed),
                  RenderImage(*subject.integrator, WholePicture(kWidth, kHeight)));
  }
  return lines;
}

// Whoever asks for nothing that takes several rays gets the pictures of one.
TEST(Distribution, WithNothingToDistributeIsWhittedBitByBit) {
  for (uint32_t seed = 0; seed < kRandomScenes; ++seed) {
    const Subject subject = MakeMeshSubject("whitted", seed);
    ASSERT_TRUE(subject.integrator);
    IntegratorOptions options;
    options.bounces = 3;
    options.shadows = true;
    const DistributionIntegrator integrator(*subject.scene, options);
    const RenderOptions picture = WholePicture(kWidth, kHeight);
    EXPECT_TRUE(RenderImage(integrator, picture) == RenderImage(*subject.integrator, picture))
        << seed;
  }
  for (const CourseScene& course : testing_support::kCourseScenes) {
    const auto scene =
        testing_support::SceneOfFile(std::filesystem::path("assets/assignment4") / course.file);
    ASSERT_TRUE(scene);
    IntegratorOptions options;
    options.bounces = course.bounces;
    options.shadows = course.shadows;
    const RenderOptions picture = WholePicture(kWidth, kHeight);
    EXPECT_TRUE(RenderImage(DistributionIntegrator(*scene, options), picture) ==
                RenderImage(WhittedIntegrator(*scene, course.bounces, course.shadows), picture))
        << course.file;
  }
}

TEST(Golden, HashesOfFloatPicturesAreTheStoredOnes) {
  const std::string lines = LinesOfCourseScenes() + LinesOfRandomScenes() + LinesOfPlacements() +
                            LinesOfMeshScenes() + LinesOfOtherIntegrators() +
                            LinesOfMovingScenes() + LinesOfDistribution();
  if (testing_support::IsUpdate()) {
    ASSERT_TRUE(WriteFileAtomically(kFile, std::as_bytes(std::span(lines))));
    return;
  }
  const Result<std::string> stored = ReadFile(kFile);
  ASSERT_TRUE(stored) << kFile << ": " << stored.error().message;
  EXPECT_EQ(lines, *stored);
}

}  // namespace
}  // namespace candela::determinism
