// candela render: a scene into pictures.

#include <fmt/format.h>

#include <optional>
#include <string>
#include <vector>

#include "candela/commands.h"
#include "driver/arg_parser.h"
#include "driver/common_options.h"
#include "driver/console.h"
#include "driver/render_request.h"
#include "film/pixel_filter.h"
#include "image/image_file.h"
#include "image/tone_curve.h"
#include "integrators/registry.h"
#include "math/elementary.h"

namespace candela {
namespace {

constexpr const char* kSummary =
    "Renders a scene into a picture. The scene is looked for as given, then among those that ship "
    "with Candela.";

/// How many samples a pixel gets where nobody says it.
constexpr uint32_t kFilteredSamples = 16;
constexpr uint32_t kPathSamples = 64;

std::vector<std::string_view> FilterNames() {
  std::vector<std::string_view> names;
  for (const PixelFilterEntry& entry : PixelFilters()) names.push_back(entry.name);
  return names;
}

std::vector<std::string_view> IntegratorNames() {
  std::vector<std::string_view> names;
  for (const IntegratorEntry& entry : IntegratorEntries()) names.push_back(entry.name);
  return names;
}

/// "whitted: the course's ...; path: ..." for the help.
std::string IntegratorSummaries() {
  std::string summaries = "how light is computed (default whitted)";
  for (const IntegratorEntry& entry : IntegratorEntries()) {
    summaries += fmt::format("; {}: {}", entry.name, entry.summary);
  }
  return summaries;
}

std::vector<std::string_view> ToneCurveNames() {
  std::vector<std::string_view> names;
  for (const ToneCurve& curve : ToneCurves()) names.push_back(curve.name);
  return names;
}

/// "none: cuts off ...; srgb: ..." for the help.
std::string ToneCurveSummaries() {
  std::string summaries =
      "how .png files show the light (default none, with path and light_trace srgb)";
  for (const ToneCurve& curve : ToneCurves()) {
    summaries += fmt::format("; {}: {}", curve.name, curve.description);
  }
  return summaries;
}

Error UsageError(std::string message) {
  return {ErrorCode::kUsage, std::move(message)};
}

/// One command line of `candela render`: its options, and what follows from them together.
class RenderCommand {
 public:
  RenderCommand() : parser_("candela render", kSummary, ArgStyle::kGnu), common_(&request_) {
    request_.program = parser_.program();
    AddOptions();
    AddExamples();
  }

  int Run(Words words) {
    if (const auto status = ReadCommandLine(parser_, words)) return *status;
    if (const auto done = Finish(); !done) return PrintError(parser_.program(), done.error());
    return RunRender(request_);
  }

 private:
  void AddOptions();
  void AddExamples();

  Result<void> Finish() {
    if (const auto done = FinishSamples(); !done) return done;
    if (const auto done = CheckPixel(); !done) return done;
    if (const auto done = FinishIsa(); !done) return done;
    if (const auto done = common_.Finish(parser_); !done) return done;
    if (const auto done = FinishWindow(); !done) return done;
    request_.integrator_options.seed = request_.render.seed;
    request_.render.grid = ChooseGrid();
    request_.output_options.png_bits = png_bits_ == "16" ? 16 : 8;
    if (const auto done = FinishTone(); !done) return done;
    return common_.FinishFiles(parser_);
  }

  Result<void> FinishSamples();
  Result<void> FinishWindow();
  Result<void> CheckPixel();
  Result<void> FinishIsa();
  Result<void> FinishTone();
  PixelGrid ChooseGrid() const;
  /// Whether the picture is one of light transport, which has defaults of its own.
  bool IsPhysical() const { return FindIntegrator(request_.integrator)->is_physical; }

  RenderRequest request_;
  ArgParser parser_;
  CommonOptions common_;
  bool jitter_ = false;
  std::string png_bits_ = "8";
  std::optional<std::string> filter_, grid_, isa_, tonemap_;
  float exposure_ = 0;
  std::optional<uint32_t> samples_;
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

  parser_.Option("tonemap", {Choice("CURVE", &tonemap_, ToneCurveNames())}, ToneCurveSummaries());
  parser_.Option("exposure", {Real("EV", &exposure_)},
                 "brightness of .png files in stops: 1 doubles the light (default 0)");

  parser_.Group("Frame");
  common_.AddFrame(&parser_);
  parser_.Option("crop",
                 {Whole("X0", &crop_.x0, 0), Whole("Y0", &crop_.y0, 0), Whole("X1", &crop_.x1, 1),
                  Whole("Y1", &crop_.y1, 1)},
                 "render only the columns from X0 and the rows from Y0 up to, not including, X1 "
                 "and Y1, counted from the top left corner");
  parser_.Option(
      "pixel-grid", {Choice("GRID", &grid_, {"corners", "centres"})},
      "whether the positions of the outermost pixels lie on the edge of the view, as in "
      "the course, or half a pixel inside (default corners, with path and light_trace centres)");

  parser_.Group("Light");
  parser_.Option("integrator", {Choice("NAME", &request_.integrator, IntegratorNames())},
                 IntegratorSummaries());
  common_.AddLight(&parser_, "0, with path and light_trace as many as it takes");
  IntegratorOptions& light = request_.integrator_options;
  parser_.Option(
      "diffuse-bounces", {Whole("N", &light.diffuse_bounces, 0)},
      "with path and light_trace: of the bounces, those by surfaces that scatter (default all)");
  parser_.Option("mirror-bounces", {Whole("N", &light.mirror_bounces, 0)},
                 "with path and light_trace: those by mirrors (default all)");
  parser_.Option("transmission-bounces", {Whole("N", &light.transmission_bounces, 0)},
                 "with path and light_trace: those through surfaces (default all)");

  parser_.Group("Samples");
  parser_.Option("samples", {Whole("N", &samples_, 1)},
                 fmt::format("samples of each pixel (default 1, with --filter {}, with path and "
                             "light_trace {})",
                             kFilteredSamples, kPathSamples));
  parser_.Option(
      "filter", {Choice("NAME", &filter_, FilterNames())},
      fmt::format("how samples are weighed: {} (default box)", fmt::join(FilterNames(), ", ")));
  parser_.Flag("jitter", &jitter_,
               "the course's 4x4 samples of each pixel, with --filter tent weighed");
  parser_.Option("seed", {Whole("N", &render.seed, 0, 4294967295)},
                 "another number gives other random positions (default 0)");

  parser_.Group("Work");
  parser_.Option("threads", {Whole("N", &request_.threads, 1, 1024)},
                 "threads to use (default one per processor); changes nothing in the picture");
  parser_.Option("isa", {Choice("SET", &isa_, {"scalar", "avx2", "avx512"})},
                 "instruction set of the search for hits: scalar, avx2 or avx512 (default the best "
                 "that the processor knows); changes nothing in the picture");
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

Result<void> RenderCommand::FinishSamples() {
  RenderOptions& render = request_.render;
  if (jitter_ && samples_) return UsageError("--jitter and --samples: give one of them");
  if (jitter_ && filter_ && *filter_ != "tent") {
    return UsageError("--jitter goes with --filter tent only; use --samples with other filters");
  }
  if (jitter_) {
    render.pattern = filter_ ? SamplePattern::kStrataTent : SamplePattern::kStrata;
    render.samples = kStrataSamples;
    return {};
  }
  const uint32_t usual = IsPhysical() ? kPathSamples : filter_ ? kFilteredSamples : 1;
  render.samples = samples_.value_or(usual);
  render.pattern = render.samples > 1 || filter_ ? SamplePattern::kFilter : SamplePattern::kCentre;
  render.filter = filter_.value_or("box");
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
  for (const char* output : {"output", "normals", "depth", "stats-json", "crop"}) {
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

Result<void> RenderCommand::FinishTone() {
  if (request_.output && FormatOf(*request_.output) != ImageFormat::kPng) {
    for (const char* name : {"tonemap", "exposure"}) {
      if (!parser_.Has(name)) continue;
      return UsageError(
          fmt::format("--{} is for .png files; the others hold the light itself", name));
    }
  }
  const std::string usual = IsPhysical() ? "srgb" : "none";
  const std::string curve = tonemap_.value_or(usual);
  ToneMapping& tone = request_.output_options.tone;
  // Without both the course's quantisation stays as it is.
  if (curve != "none" || parser_.Has("exposure")) tone.curve = FindToneCurve(curve);
  tone.gain = Exp2(exposure_);
  return {};
}

PixelGrid RenderCommand::ChooseGrid() const {
  const std::string_view usual = IsPhysical() ? "centres" : "corners";
  return grid_.value_or(std::string(usual)) == "centres" ? PixelGrid::kCentres
                                                         : PixelGrid::kCorners;
}

}  // namespace

int RunRenderCommand(Words words) {
  return RenderCommand().Run(words);
}

}  // namespace candela
