#pragma once

#include <fmt/format.h>

#include <memory>
#include <string>

#include "integrators/path.h"
#include "integrators/registry.h"
#include "tests/support/compile_text.h"
#include "tests/support/render_scene.h"

namespace candela::test {

/// What shines with radiance 1 before black.
inline std::string Shining(const std::string& transform, const std::string& shape) {
  return fmt::format(
      "Node {{ Transform {{ {} }} Component<Object> {{ type {} }} Component<Material> {{ index 0 }}"
      " Component<Light> {{ type area radiance 1 1 1 }} }}\n",
      transform, shape);
}

/// Such things, and others whose material has the index 1, as a camera sees them that looks along
/// -z from the origin.
inline std::unique_ptr<const Scene> SceneOf(const std::string& nodes, double fov = 90,
                                            const std::string& lens = "",
                                            const std::string& material = "") {
  return testing_support::CompileText(
      fmt::format("Camera {{ center 0 0 0 direction 0 0 -1 up 0 1 0 fov {} {} }}\n"
                  "Materials {{ Material {{ type diffuse albedo 0 0 0 }} Material {{ {} }} }}\n"
                  "Scene {{ {} }}",
                  fov, lens, material.empty() ? "diffuse 0 0 0" : material, nodes));
}

/// A picture of a scene in which nothing is lit.
inline Image Seen(const Scene& scene, const RenderOptions& options) {
  IntegratorOptions camera_rays;
  camera_rays.bounces = 0;
  return testing_support::RenderImage(PathIntegrator(scene, camera_rays), options);
}

/// Pixels are squares whose outer edges are those of the picture.
inline RenderOptions Picture(int width, int height, const std::string& filter, uint32_t samples) {
  RenderOptions options = testing_support::WholePicture(width, height);
  options.grid = PixelGrid::kCentres;
  options.pattern = SamplePattern::kFilter;
  options.filter = filter;
  options.samples = samples;
  return options;
}

}  // namespace candela::test
