// A picture does not depend on the accelerator that its hits are found with.
#include <gtest/gtest.h>

#include <filesystem>
#include <functional>
#include <string>

#include "integrators/whitted.h"
#include "kernel/accelerator_kind.h"
#include "tests/determinism/test_cases.h"
#include "tests/support/render_scene.h"

namespace candela::determinism {
namespace {

using testing_support::CourseScene;
using testing_support::RenderImage;
using testing_support::WholePicture;

// Without a structure a ray takes long.
constexpr int kWidth = 20, kHeight = 15;

/// `render` compiles a scene for an accelerator and renders it.
void ExpectSamePictures(const std::function<Image(AcceleratorKind)>& render) {
  const Image expected = render(AcceleratorKind::kBvh);
  EXPECT_FALSE(expected.Samples().empty());
  for (const AcceleratorEntry& entry : Accelerators()) {
    if (entry.kind == AcceleratorKind::kBvh) continue;
    EXPECT_TRUE(render(entry.kind) == expected) << entry.name;
  }
}

TEST(Accelerator, ChangesNothingInTheScenesThatShip) {
  for (const CourseScene& course : testing_support::kCourseScenes) {
    SCOPED_TRACE(course.file);
    ExpectSamePictures([&](AcceleratorKind accelerator) {
      const auto scene = testing_support::SceneOfFile(
          std::filesystem::path("assets/assignment4") / course.file, accelerator);
      if (!scene) return Image();
      EXPECT_EQ(scene->tree().group->accelerator(), accelerator);
      const WhittedIntegrator integrator(*scene, course.bounces, course.shadows);
      return RenderImage(integrator, WholePicture(kWidth, kHeight));
    });
  }
}

class AcceleratorOf : public testing::TestWithParam<const char*> {};

TEST_P(AcceleratorOf, RandomScenesChangesNothing) {
  for (uint32_t seed = 0; seed < kComparedScenes; ++seed) {
    SCOPED_TRACE(seed);
    const RenderOptions options = WholePicture(kWidth, kHeight);
    ExpectSamePictures([&](AcceleratorKind accelerator) {
      const Subject subject = MakeSubject(GetParam(), seed, accelerator);
      return RenderImage(*subject.integrator, options);
    });
  }
}

// Some of these meshes are instances, which have accelerators of their own.
TEST_P(AcceleratorOf, RandomMeshesChangesNothing) {
  for (uint32_t seed = 0; seed < kComparedScenes; ++seed) {
    SCOPED_TRACE(seed);
    const RenderOptions options = WholePicture(kWidth, kHeight);
    ExpectSamePictures([&](AcceleratorKind accelerator) {
      const Subject subject = MakeMeshSubject(GetParam(), seed, accelerator);
      return RenderImage(*subject.integrator, options);
    });
  }
}

TEST_P(AcceleratorOf, MovingScenesChangesNothing) {
  for (uint32_t seed = 0; seed < kComparedScenes; ++seed) {
    SCOPED_TRACE(seed);
    const RenderOptions options = WholePicture(kWidth, kHeight);
    ExpectSamePictures([&](AcceleratorKind accelerator) {
      const Subject subject = MakeMovingSubject(GetParam(), seed, accelerator);
      return RenderImage(*subject.integrator, options);
    });
  }
}

INSTANTIATE_TEST_SUITE_P(All, AcceleratorOf, testing::Values("whitted", "path", "light_trace"),
                         [](const auto& test) { return std::string(test.param); });

}  // namespace
}  // namespace candela::determinism
