// Measures ways of choosing one of many lights in a room with small lamps of uneven power. Prints
// one table.

#include <fmt/format.h>

#include <memory>
#include <span>
#include <string>

#include "base/cancel_token.h"
#include "base/check.h"
#include "base/diagnostics.h"
#include "base/parallel.h"
#include "driver/arg_parser.h"
#include "driver/console.h"
#include "film/encode_film.h"
#include "integrators/path.h"
#include "integrators/registry.h"
#include "lamp_room.h"
#include "lights/light_choice.h"
#include "lights/light_picker.h"
#include "loaders/course/scene_parser.h"
#include "picture_error.h"
#include "render/render_job.h"
#include "scene/compile_scene.h"
#include "support/cpu_seconds.h"
#include "support/document_table.h"
#include "support/run_bench.h"

namespace candela {
namespace {

constexpr const char* kName = "light_bench";

struct BenchOptions {
  uint32_t lamps = 10'000;
  int side = 64;
  uint32_t samples = 64, reference = 8192;
  bool print_scene = false;
  bool update = false;
};

struct Picture {
  Image image;
  double seconds;
};

Picture Render(const Scene& scene, LightChoice choice, int side, uint32_t samples, uint32_t seed) {
  IntegratorOptions light;
  light.light_choice = choice;
  light.bounces = 3;
  RenderOptions options;
  options.width = options.height = side;
  options.crop = {0, 0, side, side};
  options.grid = PixelGrid::kCentres;
  options.pattern = SamplePattern::kFilter;
  options.samples = samples;
  light.seed = options.seed = seed;
  light.sampler = options.sampler = SamplerType(SamplerKind::kSobol, samples);
  const auto integrator = PathIntegrator::Create(scene, light);
  CHECK(integrator.ok());
  const double begin = CpuSeconds();
  RenderJob job(**integrator, options);
  CHECK(job.Run(CancelToken()).ok());
  const double seconds = CpuSeconds() - begin;
  return {ToImage(job.film()), seconds};
}

Result<std::string> Table(const BenchOptions& options) {
  const double begin = CpuSeconds();
  Diagnostics diagnostics;
  const SceneSpec spec = ParseScene(std::make_shared<const std::string>("room"),
                                    LampRoom(options.lamps), ".", &diagnostics);
  const auto scene = CompileScene(spec, &diagnostics);
  if (!scene) return diagnostics.FirstError().error();
  const double loaded = CpuSeconds();
  std::vector<const Light*> lights;
  for (const auto& light : scene->lights()) lights.push_back(light.get());
  const double tree_begin = CpuSeconds();
  const LightPicker picker(lights, 1, LightChoice::kByEffect);
  const double tree_seconds = CpuSeconds() - tree_begin;

  const auto reference =
      Render(*scene, LightChoice::kByEffect, options.side, options.reference, 1).image;
  std::string text = fmt::format(
      "{} lamps, {} x {} pixels, {} samples, 3 bounces, one thread; the error is that to a picture "
      "of {} samples. Reading and compiling the scene takes {:.0f} ms, the tree {:.1f} ms and "
      "{:.2f} "
      "MB.\n\n"
      "| choice | relMSE | CPU s | relMSE x time | to uniform |\n"
      "|---|---:|---:|---:|---:|\n",
      options.lamps, options.side, options.side, options.samples, options.reference,
      1000 * (loaded - begin), 1000 * tree_seconds,
      static_cast<double>(picker.MemoryBytes()) / 1e6);
  double of_uniform = 0;
  for (const char* name : {"uniform", "power", "effect"}) {
    const LightChoiceEntry& entry = *FindLightChoice(name);
    const Picture picture = Render(*scene, entry.choice, options.side, options.samples, 0);
    const double error = TrimmedRelativeError(picture.image, reference);
    const double product = error * picture.seconds;
    if (entry.choice == LightChoice::kUniform) of_uniform = product;
    text += fmt::format("| {} | {:.3g} | {:.2f} | {:.3g} | {:.3g} |\n", name, error,
                        picture.seconds, product, product / of_uniform);
  }
  return text;
}

Result<void> Run(const BenchOptions& options) {
  if (options.print_scene) return WriteResult(LampRoom(options.lamps));
  const ThreadLimit one_thread(1);
  const Result<std::string> table = Table(options);
  if (!table) return table.error();
  return Publish("light bench", *table, options.update);
}

int Main(std::span<const char* const> words) {
  BenchOptions options;
  ArgParser parser(kName,
                   "Measures ways of choosing one of many lights. Runs in the root of the project.",
                   ArgStyle::kGnu);
  parser.Group("What is measured");
  parser.Option("lamps", {Whole("N", &options.lamps, 1, 10'000'000)},
                "in the room; the default is 10000");
  parser.Option("size", {Whole("N", &options.side, 1, 10000)},
                "side of the pictures in pixels; the default is 64");
  parser.Option("samples", {Whole("N", &options.samples, 1)}, "the default is 64");
  parser.Option("reference", {Whole("N", &options.reference, 1)},
                "samples of the picture to compare with; the default is 8192");
  parser.Group("Results");
  parser.Flag("scene", &options.print_scene, "print the scene, and measure nothing");
  parser.Flag("update", &options.update, "put the table into docs/performance.md");
  return RunBench(parser, words, [&] { return Run(options); });
}

}  // namespace
}  // namespace candela

int main(int argc, char** argv) {
  return candela::Main(candela::WordsOf(argc, argv));
}
