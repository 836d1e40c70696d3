#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "image/raster.h"
#include "integrators/integrator.h"
#include "kernel/accelerator_kind.h"
#include "render/render_options.h"
#include "scene/scene.h"
#include "scene_spec/scene_spec.h"

namespace candela::testing_support {

/// A scene that ships with the project or with the course, under the name that both use, and the
/// flags it is meant to be rendered with.
struct CourseScene {
  const char* file;
  uint32_t bounces = 0;
  bool shadows = false;
};
inline constexpr CourseScene kCourseScenes[] = {
    {"scene01_plane.txt"},         {"scene02_cube.txt"},      {"scene03_sphere.txt"},
    {"scene04_axes.txt"},          {"scene05_bunny_200.txt"}, {"scene06_bunny_1k.txt", 4},
    {"scene07_arch.txt", 4, true},
};
/// By its number, from 1.
inline const CourseScene& CourseSceneOf(int number) {
  return kCourseScenes[number - 1];
}

/// Compiled from a file, from text whose files lie in `folder`, or from a description. Errors and
/// warnings fail the test; null when there were errors.
std::unique_ptr<Scene> SceneOfFile(const std::filesystem::path& path,
                                   AcceleratorKind accelerator = AcceleratorKind::kBvh);
std::unique_ptr<Scene> SceneOfText(const std::string& text,
                                   const std::filesystem::path& folder = ".",
                                   AcceleratorKind accelerator = AcceleratorKind::kBvh);
std::unique_ptr<Scene> SceneOfSpec(const SceneSpec& spec,
                                   AcceleratorKind accelerator = AcceleratorKind::kBvh);

/// One sample in the middle of each pixel, all of them rendered.
RenderOptions WholePicture(int width, int height);

/// The unclamped picture of the crop window.
Image RenderImage(const Integrator& integrator, const RenderOptions& options);

/// What a PNG file of 8 bits keeps of a picture, by way of such a file.
Image ThroughPng(const Image& image);

/// A picture from a file. What is wrong with it fails the test.
Image ReadPictureOf(const std::filesystem::path& path);

}  // namespace candela::testing_support
