// candela render: a scene into pictures.

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "candela/commands.h"
#include "candela/picture_settings.h"
#include "candela/render_settings.h"
#include "candela/table_options.h"
#include "driver/arg_parser.h"
#include "driver/common_options.h"
#include "driver/console.h"
#include "driver/render_request.h"
#include "image/image_file.h"
#include "integrators/registry.h"
#include "kernel/accelerator_kind.h"

namespace candela {
namespace {

constexpr const char* kSummary =
    "Renders a scene into a picture. The scene is looked for as given, then among those that ship "
    "with Candela.";

/// One command line of `candela render`: its options, and what follows from them together.
class RenderCommand {
 public:
  RenderCommand()
      : parser_("candela render", kSummary, ArgStyle::kGnu),
        common_(&request_),
        picture_(&request_) {
    request_.program = parser_.program();
    AddOptions();
    AddExamples();
  }

  int Run(Words words) {
    if (const auto status = ReadCommandLine(parser_, words)) return *status;
    if (const auto done = CheckOptions(); !done) return PrintError(parser_.program(), done.error());
    return RunRender(
        request_,
        [this](const SceneSpec& spec, Diagnostics* diagnostics) -> Result<CompileOptions> {
          ReadSettings(spec, diagnostics);
          if (const auto done = Finish(); !done) return done.error();
          return Compilation();
        });
  }

  /// What a scene says about its rendering, for options that were not given.
  void ReadSettings(const SceneSpec& spec, Diagnostics* diagnostics);
  /// What `candela render` would use for such a scene.
  RenderSettings FinishSettings() {
    picture_.Finish();
    return {parser_.ShowBlock("Render"), parser_.ShowBlock("Film"), request_.integrator,
            Compilation()};
  }

 private:
  CompileOptions Compilation() const {
    CompileOptions options;
    options.accelerator = FindAccelerator(request_.accelerator)->kind;
    return options;
  }

  void AddOptions();
  void AddExamples();

  /// What can be said without the scene.
  Result<void> CheckOptions() {
    if (const auto done = picture_.CheckJitter(); !done) return done;
    if (const auto done = CheckPixel(); !done) return done;
    if (const auto done = FinishIsa(); !done) return done;
    if (const auto done = common_.Finish(parser_); !done) return done;
    if (const auto done = picture_.CheckTone(parser_); !done) return done;
    if (const auto done = CheckPngBits(); !done) return done;
    if (const auto done = CheckLayers(); !done) return done;
    if (const auto done = CheckCheckpoint(); !done) return done;
    request_.output_options.has_facts = true;
    request_.output_options.png_bits = png_bits_ == "16" ? 16 : 8;
    return common_.FinishFiles(parser_);
  }

  /// The rest, once the settings of the scene are known.
  Result<void> Finish() {
    picture_.Finish();
    if (const auto done = common_.FinishSize(parser_); !done) return done;
    if (const auto done = picture_.CheckFilm(parser_); !done) return done;
    if (const auto done = picture_.CheckStop(parser_); !done) return done;
    if (const auto done = CheckAbilities(); !done) return done;
    return FinishWindow();
  }

  Result<void> CheckPixel();
  Result<void> FinishIsa();
  Result<void> CheckPngBits() const;
  Result<void> CheckLayers() const;
  Result<void> CheckCheckpoint() const;
  /// Whether the integrator can do what is asked of it.
  Result<void> CheckAbilities() const;
  Result<void> FinishWindow();

  RenderRequest request_;
  ArgParser parser_;
  CommonOptions common_;
  PictureSettings picture_;
  std::string png_bits_ = "8";
  std::optional<std::string> isa_;
  PixelWindow crop_;
  RenderRequest::PixelPosition pixel_{};
};

void RenderCommand::AddOptions() {
  RenderOptions& render = request_.render;
  parser_.Positional(File("SCENE", &request_.scene), "scene to read");

  parser_.Group("Pictures");
  common_.AddPictures(&parser_);
  parser_.Option("png-bits", {Choice("BITS", &png_bits_, {"8", "16"})},
                 "bits of each channel in .png files: 8 (default) or 16");
  parser_.Option("aov", {LayerNames(&render.layers)}, LayerSummaries());
  picture_.AddTone(&parser_);

  parser_.Group("Frame");
  common_.AddFrame(&parser_);
  parser_.Option("crop",
                 {Whole("X0", &crop_.x0, 0), Whole("Y0", &crop_.y0, 0), Whole("X1", &crop_.x1, 1),
                  Whole("Y1", &crop_.y1, 1)},
                 "render only the columns from X0 and the rows from Y0 up to, not including, X1 "
                 "and Y1, counted from the top left corner");
  picture_.AddGrid(&parser_);

  parser_.Group("Light");
  picture_.AddLight(&parser_, &common_);

  parser_.Group("Samples");
  picture_.AddSamples(&parser_);

  parser_.Group("Work");
  parser_.Option("threads", {Whole("N", &request_.threads, 1, 1024)},
                 "threads to use (default one per processor); changes nothing in the picture");
  parser_.Option("accelerator", {Choice("NAME", &request_.accelerator, AcceleratorNames())},
                 AcceleratorSummaries(), {.block = "Render"});
  parser_.Option(
      "isa", {Choice("SET", &isa_, {"scalar", "avx2", "avx512"})},
      "instruction set of the search for hits and of random numbers: scalar, avx2 or "
      "avx512 (default the best that the processor knows); changes nothing in the picture");
  parser_.Option("checkpoint", {File("FILE", &request_.checkpoint)},
                 "keep what was rendered, at the end, when stopped, and now and then, and go on "
                 "from there when the file exists: as far as --samples says");
  parser_.Option("checkpoint-every", {NotNegative("SECONDS", &request_.checkpoint_seconds)},
                 "how often in a long render (default 300)");
  parser_.Flag("quiet", &request_.quiet, "show no progress");
  parser_.Flag("stats", &request_.print_stats, "print times, rays and memory to stderr");
  parser_.Option("stats-json", {File("FILE", &request_.stats_json)}, "write the same as JSON");
  parser_.Option("pixel", {Whole("X", &pixel_.x, 0), Whole("Y", &pixel_.y, 0)},
                 "render nothing, but tell what the rays of this pixel meet");
}

void RenderCommand::AddExamples() {
  parser_.Example("scene07_arch.txt -o arch.png --shadows --bounces 4", "a picture of 800 x 800");
  parser_.Example("scene.txt -o hd.exr --size 1920 1080 --samples 16 --filter gaussian --stats",
                  "smooth edges, unclamped values, and where the time went");
  parser_.Example("scene.txt --size 1920 1080 --pixel 960 540",
                  "why a pixel has the colour it has");
}

void RenderCommand::ReadSettings(const SceneSpec& spec, Diagnostics* diagnostics) {
  parser_.ReadBlock("Render", spec.render.params, diagnostics);
  parser_.ReadBlock("Film", spec.film.params, diagnostics);
  const Param* size = spec.film.params.Find("size");
  if (const auto fits = common_.FinishSize(parser_); !fits && size) {
    diagnostics->Error(size->where,
                       fmt::format("'size' expects sides of at most {} pixels", kLargestCount),
                       fits.error().code);
  }
  picture_.MergeFilm(parser_, spec, diagnostics);
  picture_.DropSamplesOfScene(parser_);
  picture_.CheckForIntegrator(parser_, spec.render.params, diagnostics);
}

Result<void> RenderCommand::CheckCheckpoint() const {
  if (!request_.checkpoint) {
    return parser_.Has("checkpoint-every") ? UsageError("--checkpoint-every goes with --checkpoint")
                                           : Result<void>();
  }
  if (!request_.output) return UsageError("--checkpoint keeps the picture of --output: give both");
  if (request_.render.layers.IsEmpty()) return {};
  return UsageError("--checkpoint and --aov: a checkpoint does not hold layers");
}

Result<void> RenderCommand::CheckPngBits() const {
  if (!parser_.Has("png-bits")) return {};
  const auto pictures = request_.Pictures();
  const bool has_png = std::ranges::any_of(
      pictures, [](const auto& path) { return FormatOf(path) == ImageFormat::kPng; });
  if (has_png) return {};
  return UsageError("--png-bits is for .png files, of which none would be written");
}

Result<void> RenderCommand::CheckLayers() const {
  if (request_.render.layers.IsEmpty()) return {};
  if (request_.output && FormatOf(*request_.output) == ImageFormat::kExr) return {};
  return UsageError("--aov: layers go into the picture of --output, which has to be an .exr file");
}

Result<void> RenderCommand::CheckAbilities() const {
  const IntegratorEntry& integrator = *FindIntegrator(request_.integrator);
  if (!request_.render.layers.IsEmpty() && !integrator.has_layers) {
    return UsageError(fmt::format("--aov: the integrator '{}' has no layers", integrator.name));
  }
  if (request_.render.layers.Has(Layer::kLightGroups) && !integrator.has_light_groups) {
    return UsageError(fmt::format(
        "--aov light_groups: the integrator '{}' does not tell the light of groups apart",
        integrator.name));
  }
  if (request_.checkpoint && integrator.has_light_paths) {
    return UsageError(
        fmt::format("--checkpoint: what '{}' has done cannot be kept", integrator.name));
  }
  if (request_.render.clamp && integrator.has_light_paths) {
    return UsageError(fmt::format("--clamp: what light paths of '{}' bring has no samples to clamp",
                                  integrator.name));
  }
  return {};
}

Result<void> RenderCommand::FinishWindow() {
  const RenderOptions& render = request_.render;
  if (parser_.Has("crop")) {
    if (crop_.x0 >= crop_.x1 || crop_.y0 >= crop_.y1) {
      return UsageError("--crop: X0 has to be less than X1, and Y0 less than Y1");
    }
    if (!render.crop.Contains(crop_)) {
      return UsageError(fmt::format("--crop: reaches beyond the picture of {} x {} pixels",
                                    render.width, render.height));
    }
    request_.render.crop = crop_;
  }
  const bool is_inside = pixel_.x < render.width && pixel_.y < render.height;
  if (!is_inside) {
    return UsageError(fmt::format("--pixel: lies outside the picture of {} x {} pixels",
                                  render.width, render.height));
  }
  return {};
}

Result<void> RenderCommand::CheckPixel() {
  if (!parser_.Has("pixel")) return {};
  for (const char* output : {"output", "normals", "depth", "stats", "stats-json", "crop"}) {
    if (parser_.Has(output)) {
      return UsageError(fmt::format("--pixel renders nothing, so --{} cannot be given", output));
    }
  }
  request_.explain = pixel_;
  return {};
}

Result<void> RenderCommand::FinishIsa() {
  if (!isa_) return {};
  request_.isa = FindIsa(*isa_);
  if (IsSupported(*request_.isa)) return {};
  return UsageError(fmt::format("--isa: this processor does not know {}", *isa_));
}

}  // namespace

RenderSettings ReadRenderSettings(const SceneSpec& spec, Diagnostics* diagnostics) {
  RenderCommand command;
  command.ReadSettings(spec, diagnostics);
  return command.FinishSettings();
}

int RunRenderCommand(Words words) {
  return RenderCommand().Run(words);
}

}  // namespace candela
