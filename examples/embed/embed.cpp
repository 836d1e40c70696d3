// Renders a scene that the program itself holds, and writes embed.png into the working folder.
#include <candela/candela.h>

#include <algorithm>
#include <cstdio>

using namespace candela;

constexpr const char* kScene = R"(
  Background { color 0.1 0.1 0.2  ambient_light 0.1 0.1 0.1 }
  Camera { center 0 0 5  direction 0 0 -1  up 0 1 0  fov 40 }
  Materials { Material { diffuse 0.9 0.4 0.1 } }
  Scene {
    Node { Component<Light> { type directional  direction -1 -1 -1  color 1 1 1 } }
    Node { Component<Material> { index 0 }  Component<Object> { type sphere  radius 1 } }
  })";

int main() {
  Diagnostics diagnostics;
  const auto name = std::make_shared<const std::string>("embedded scene");
  const SceneSpec spec = ParseScene(name, kScene, ".", &diagnostics);
  const std::unique_ptr<Scene> scene = CompileScene(spec, &diagnostics);
  for (const std::string& line : diagnostics.Lines()) std::fprintf(stderr, "%s\n", line.c_str());
  if (!scene) return 1;

  RenderOptions options;
  options.width = options.height = 200;
  options.crop = {0, 0, 200, 200};
  const auto integrator = CreateIntegrator("whitted", *scene, {}).value();
  RenderJob job(*integrator, options);
  if (!job.Run(CancelToken())) return 1;

  Image image(200, 200, 3);
  for (int y = 0; y < 200; ++y) std::ranges::copy(job.film().Row(y), image.Row(y).begin());
  const std::string png = EncodeImage(image, ImageFormat::kPng).value();
  return WriteFileAtomically("embed.png", std::as_bytes(std::span(png))) ? 0 : 1;
}
