#include "tests/support/render_scene.h"

#include <gtest/gtest.h>

#include "base/diagnostics.h"
#include "film/encode_film.h"
#include "image/image_file.h"
#include "loaders/course/scene_parser.h"
#include "render/render_job.h"
#include "scene/compile_scene.h"

namespace candela::testing_support {
namespace {

std::unique_ptr<Scene> Compile(const SceneSpec& spec, AcceleratorKind accelerator,
                               Diagnostics* diagnostics) {
  CompileOptions options;
  options.accelerator = accelerator;
  std::unique_ptr<Scene> scene;
  if (!diagnostics->HasErrors()) scene = CompileScene(spec, diagnostics, options);
  for (const std::string& line : diagnostics->Lines()) ADD_FAILURE() << line;
  return scene;
}

}  // namespace

std::unique_ptr<Scene> SceneOfFile(const std::filesystem::path& path, AcceleratorKind accelerator) {
  Diagnostics diagnostics;
  const SceneSpec spec = LoadScene(path, &diagnostics);
  return Compile(spec, accelerator, &diagnostics);
}

std::unique_ptr<Scene> SceneOfText(const std::string& text, const std::filesystem::path& folder,
                                   AcceleratorKind accelerator) {
  Diagnostics diagnostics;
  const SceneSpec spec =
      ParseScene(std::make_shared<const std::string>("text"), text, folder, &diagnostics);
  return Compile(spec, accelerator, &diagnostics);
}

std::unique_ptr<Scene> SceneOfSpec(const SceneSpec& spec, AcceleratorKind accelerator) {
  Diagnostics diagnostics;
  return Compile(spec, accelerator, &diagnostics);
}

RenderOptions WholePicture(int width, int height) {
  RenderOptions options;
  options.width = width;
  options.height = height;
  options.crop = {0, 0, width, height};
  return options;
}

Image RenderImage(const Integrator& integrator, const RenderOptions& options) {
  RenderJob job(integrator, options);
  const CancelToken never;
  EXPECT_TRUE(job.Run(never));
  return ToImage(job.film());
}

Image ThroughPng(const Image& image) {
  const Result<std::string> bytes = EncodeImage(image, ImageFormat::kPng);
  if (!bytes) {
    ADD_FAILURE() << bytes.error().message;
    return {};
  }
  const Result<Image> back = DecodeImage(*bytes);
  if (!back) ADD_FAILURE() << back.error().message;
  return back ? *back : Image();
}

Image ReadPictureOf(const std::filesystem::path& path) {
  std::vector<std::string> warnings;
  const Result<Image> image = ReadImage(path, &warnings);
  if (!image) ADD_FAILURE() << path << ": " << image.error().message;
  for (const std::string& warning : warnings) ADD_FAILURE() << path << ": " << warning;
  return image ? *image : Image();
}

}  // namespace candela::testing_support
