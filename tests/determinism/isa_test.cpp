// A picture does not depend on the instruction set that its hits are searched with and its random
// numbers are drawn with.
#include <gtest/gtest.h>

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "base/isa.h"
#include "integrators/whitted.h"
#include "tests/determinism/test_cases.h"
#include "tests/support/forced_isa.h"
#include "tests/support/render_scene.h"

namespace candela::determinism {
namespace {

using test::ForcedIsa;
using testing_support::CourseScene;
using testing_support::RenderImage;
using testing_support::WholePicture;

constexpr int kWidth = 56, kHeight = 40;

/// `render` compiles a scene and renders it.
void ExpectSamePictures(const std::function<Image()>& render) {
  Image expected;
  {
    const ForcedIsa forced(Isa::kScalar);
    expected = render();
  }
  for (const Isa isa : {Isa::kAvx2, Isa::kAvx512}) {
    if (!IsSupported(isa)) continue;
    const ForcedIsa forced(isa);
    EXPECT_TRUE(render() == expected) << IsaName(isa);
  }
}

TEST(InstructionSet, ChangesNothingInTheScenesThatShip) {
  for (const CourseScene& course : testing_support::kCourseScenes) {
    SCOPED_TRACE(course.file);
    ExpectSamePictures([&] {
      const auto scene =
          testing_support::SceneOfFile(std::filesystem::path("assets/assignment4") / course.file);
      if (!scene) return Image();
      const WhittedIntegrator integrator(*scene, course.bounces, course.shadows);
      return RenderImage(integrator, WholePicture(kWidth, kHeight));
    });
  }
}

class InstructionSetOf : public testing::TestWithParam<const char*> {};

TEST_P(InstructionSetOf, RandomScenesChangesNothing) {
  for (uint32_t seed = 0; seed < kComparedScenes; ++seed) {
    SCOPED_TRACE(seed);
    const RenderOptions options = OptionsFor(AllPlacements().back(), kWidth, kHeight);
    ExpectSamePictures([&] {
      const Subject subject = MakeSubject(GetParam(), seed);
      return RenderImage(*subject.integrator, options);
    });
  }
}

TEST_P(InstructionSetOf, RandomMeshesChangesNothing) {
  for (uint32_t seed = 0; seed < kComparedScenes; ++seed) {
    SCOPED_TRACE(seed);
    const RenderOptions options = OptionsFor(AllPlacements().back(), kWidth, kHeight);
    ExpectSamePictures([&] {
      const Subject subject = MakeMeshSubject(GetParam(), seed);
      return RenderImage(*subject.integrator, options);
    });
  }
}

INSTANTIATE_TEST_SUITE_P(All, InstructionSetOf, testing::Values("whitted", "path", "light_trace"),
                         [](const auto& test) { return std::string(test.param); });

}  // namespace
}  // namespace candela::determinism
