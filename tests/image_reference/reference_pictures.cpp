#include "tests/image_reference/reference_pictures.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <vector>

#include "driver/map_images.h"
#include "integrators/whitted.h"
#include "render/render_first_hits.h"
#include "tests/support/course_folder.h"
#include "tests/support/render_scene.h"

namespace candela::image_reference {
namespace {

using enum PictureKind;
using testing_support::CourseFolder;
using testing_support::CourseScene;
using testing_support::CourseSceneOf;

constexpr ReferencePicture kPictures[] = {
    {1, kColour, 200}, {1, kColour, 800}, {1, kNormals, 200}, {1, kDepth, 200},
    {2, kColour, 200}, {2, kColour, 800}, {2, kNormals, 200}, {2, kDepth, 200},
    {3, kColour, 200}, {3, kColour, 800}, {3, kNormals, 200}, {3, kDepth, 200},
    {4, kColour, 200}, {4, kColour, 800}, {4, kNormals, 200}, {4, kDepth, 200},
    {5, kColour, 200}, {5, kColour, 800}, {5, kNormals, 200}, {5, kDepth, 200},
    {6, kColour, 300}, {6, kColour, 800}, {7, kColour, 300},  {7, kColour, 800},
};

int64_t Share(double percent, int64_t pixels) {
  return static_cast<int64_t>(percent * static_cast<double>(pixels) / 100);
}

/// The range of distances that the depth maps of a scene show. The reference cut the range that was
/// asked of scene 5 (0.8 to 1) to whole numbers.
DepthOutput DepthRange(int scene) {
  if (scene == 5) return {0, 1, {}};
  return {8, 18, {}};
}

/// Black wherever nothing is hit; the number of the other pixels.
int64_t KeepHits(const std::vector<FirstHit>& hits, Image* image) {
  int64_t kept = 0;
  for (int y = 0; y < image->Height(); ++y) {
    for (int x = 0; x < image->Width(); ++x) {
      const auto index = static_cast<size_t>(int64_t{y} * image->Width() + x);
      if (hits[index].is_hit) {
        ++kept;
      } else {
        std::ranges::fill(image->Pixel(x, y), 0.0f);
      }
    }
  }
  return kept;
}

Comparison Compare(const ReferencePicture& picture) {
  const CourseScene& course = CourseSceneOf(picture.scene);
  const auto scene = testing_support::SceneOfFile(CourseFolder() / "assets" / course.file);
  if (!scene) return {};
  Comparison result;
  result.reference =
      testing_support::ReadPictureOf(CourseFolder() / "reference" / (picture.Name() + ".png"));
  result.compared = result.reference.PixelCount();

  const RenderOptions options = testing_support::WholePicture(picture.side, picture.side);
  Image ours;
  if (picture.kind == kColour) {
    const WhittedIntegrator integrator(*scene, course.bounces, course.shadows);
    ours = testing_support::RenderImage(integrator, options);
  } else {
    const auto hits = RenderFirstHits(*scene, options);
    if (picture.kind == kDepth) {
      ours = DepthImage(hits, options.crop, DepthRange(picture.scene), ImageFormat::kPng);
    } else {
      ours = NormalImage(hits, options.crop, ImageFormat::kPng);
      result.compared = KeepHits(hits, &result.reference);
    }
  }
  result.ours = testing_support::ThroughPng(ours);
  const auto difference = CompareImages(result.ours, result.reference);
  if (!difference) {
    ADD_FAILURE() << difference.error().message;
    return {};
  }
  result.difference = *difference;
  return result;
}

}  // namespace

int64_t Bar::MostDiffering(int64_t pixels) const {
  return Share(differing_percent, pixels);
}

int64_t Bar::MostBeyondOneLevel(int64_t pixels) const {
  return std::max(beyond_pixels, Share(beyond_percent, pixels));
}

std::string ReferencePicture::Name() const {
  const char* middle = kind == kNormals ? "normals_" : kind == kDepth ? "depth_" : "";
  return fmt::format("{:02}_{}{}", scene, middle, side);
}

Bar ReferencePicture::bar() const {
  constexpr double kLeastPsnr = 45;  // A single pixel that turns from black to white costs as much.
  if (kind == kNormals) return {0.5, 0, 0, kLeastPsnr};
  if (kind == kDepth) return {0.1, 0, 0, kLeastPsnr};
  // Lone pixels on the edges of cubes that are seen edge-on, by any amount.
  if (scene == 4) return {0.01, 0.01, 0, kLeastPsnr};
  // Rays that leave the mirroring floor graze the mesh.
  if (scene == 6) return {1.5, 0.06, 0, 50};
  return {0.1, 0.002, 4, kLeastPsnr};
}

std::span<const ReferencePicture> ReferencePictures() {
  return kPictures;
}

bool HaveReference() {
  return std::filesystem::is_directory(CourseFolder() / "reference");
}

std::string NoReference() {
  return "not run: the course's scenes and pictures are not there (" + CourseFolder().string() +
         ")";
}

double Comparison::DifferingPercent() const {
  return 100 * static_cast<double>(difference.differing) / static_cast<double>(compared);
}

bool Comparison::Meets(const Bar& bar) const {
  return compared > 0 && difference.differing <= bar.MostDiffering(compared) &&
         difference.beyond_one_level <= bar.MostBeyondOneLevel(compared) &&
         difference.psnr >= bar.least_psnr;
}

const Comparison& CompareWithReference(const ReferencePicture& picture) {
  static std::map<std::string, Comparison> done;
  const auto found = done.find(picture.Name());
  return found != done.end() ? found->second : done[picture.Name()] = Compare(picture);
}

}  // namespace candela::image_reference
