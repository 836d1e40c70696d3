// The project's own scenes against the pictures in expected/. Rendering is deterministic across
// machines and compilers, so they are equal. CANDELA_UPDATE=1 writes the pictures instead.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <span>

#include "base/files.h"
#include "driver/map_images.h"
#include "image/compare.h"
#include "image/image_file.h"
#include "integrators/whitted.h"
#include "render/render_first_hits.h"
#include "tests/support/picture_check.h"
#include "tests/support/render_scene.h"

namespace candela {
namespace {

namespace fs = std::filesystem;
using testing_support::CourseScene;
using testing_support::CourseSceneOf;

// Tests run in the root of the project.
const fs::path kScenes = "assets/assignment4";
const fs::path kExpected = "tests/image_own/expected";
constexpr int kSide = 200;

/// One stored picture and what of a scene it shows.
struct OwnPicture {
  enum Kind { kColour, kJitter, kFilter, kWide, kNormals, kDepth };

  const char* name;
  int scene;  ///< From 1.
  Kind kind = kColour;
};

constexpr OwnPicture kPictures[] = {
    {"01_plane", 1},
    {"02_cube", 2},
    {"03_sphere", 3},
    {"04_axes", 4},
    {"05_rabbit", 5},
    {"06_rabbit", 6},
    {"07_arch", 7},
    {"04_axes_wide", 4, OwnPicture::kWide},
    {"06_rabbit_jitter", 6, OwnPicture::kJitter},
    {"07_arch_filter", 7, OwnPicture::kFilter},
    {"05_rabbit_normals", 5, OwnPicture::kNormals},
    {"01_plane_depth", 1, OwnPicture::kDepth},
};

RenderOptions OptionsOf(OwnPicture::Kind kind) {
  RenderOptions options =
      testing_support::WholePicture(kSide, kind == OwnPicture::kWide ? kSide / 2 : kSide);
  if (kind == OwnPicture::kJitter || kind == OwnPicture::kFilter) {
    options.pattern =
        kind == OwnPicture::kJitter ? SamplePattern::kStrata : SamplePattern::kStrataTent;
    options.samples = kStrataSamples;
  }
  return options;
}

Image Render(const OwnPicture& picture) {
  const CourseScene& course = CourseSceneOf(picture.scene);
  const auto scene = testing_support::SceneOfFile(kScenes / course.file);
  if (!scene) return {};
  const RenderOptions options = OptionsOf(picture.kind);
  if (picture.kind == OwnPicture::kNormals) {
    return NormalImage(RenderFirstHits(*scene, options), options.crop, ImageFormat::kPng);
  }
  if (picture.kind == OwnPicture::kDepth) {
    return DepthImage(RenderFirstHits(*scene, options), options.crop, {8, 18, {}},
                      ImageFormat::kPng);
  }
  return testing_support::RenderImage(WhittedIntegrator(*scene, course.bounces, course.shadows),
                                      options);
}

/// Writes the picture unless the file already shows the same: other bytes alone are no change.
void Store(const fs::path& path, const Image& image) {
  if (fs::exists(path)) {
    const Image old = testing_support::ReadPictureOf(path);
    if (testing_support::ThroughPng(image) == old) return;
  }
  const Result<std::string> bytes = EncodeImage(image, ImageFormat::kPng);
  ASSERT_TRUE(bytes);
  ASSERT_TRUE(WriteFileAtomically(path, std::as_bytes(std::span(*bytes))));
}

class Own : public testing::TestWithParam<OwnPicture> {};

TEST_P(Own, PictureIsTheStoredOne) {
  const OwnPicture& picture = GetParam();
  const fs::path path = kExpected / (std::string(picture.name) + ".png");
  const Image image = Render(picture);
  if (testing_support::IsUpdate()) {
    Store(path, image);
    return;
  }
  const Image ours = testing_support::ThroughPng(image);
  const Image expected = testing_support::ReadPictureOf(path);
  const auto difference = CompareImages(ours, expected);
  ASSERT_TRUE(difference) << difference.error().message;
  EXPECT_EQ(difference->differing, 0)
      << fmt::format("{} pixels differ, by {:.0f} levels at most; ", difference->differing,
                     difference->LargestInLevels())
      << testing_support::StoreForInspection(picture.name, ours, expected);
}

INSTANTIATE_TEST_SUITE_P(Pictures, Own, testing::ValuesIn(kPictures),
                         [](const auto& test) { return std::string(test.param.name); });

TEST(OwnPictures, EachStoredFileIsCompared) {
  if (testing_support::IsUpdate()) GTEST_SKIP() << "the pictures are only being written";
  std::set<std::string> stored, compared;
  for (const auto& entry : fs::directory_iterator(kExpected)) {
    stored.insert(entry.path().stem().string());
  }
  for (const OwnPicture& picture : kPictures) compared.insert(picture.name);
  EXPECT_EQ(stored, compared);
}

}  // namespace
}  // namespace candela
