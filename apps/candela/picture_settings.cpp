#include "candela/picture_settings.h"

#include <fmt/format.h>

#include <string_view>

#include "candela/table_options.h"
#include "driver/console.h"
#include "image/image_file.h"
#include "image/tone_curve.h"
#include "integrators/distribution.h"
#include "integrators/registry.h"
#include "integrators/whitted.h"
#include "sampling/sampler.h"

namespace candela {
namespace {

/// How many samples a pixel gets where nobody says it.
constexpr uint32_t kFilteredSamples = 16;
constexpr uint32_t kPathSamples = 64;

/// Options that are settings of a scene as well.
constexpr ArgTraits kInRender{.block = "Render"}, kInFilm{.block = "Film"};

}  // namespace

void PictureSettings::AddTone(ArgParser* parser) {
  parser->Option("tonemap", {Choice("CURVE", &tonemap_, ToneCurveNames())}, ToneCurveSummaries(),
                 kInFilm);
  exposure_.Add(parser);
  lens_.Add(parser);
}

void PictureSettings::AddGrid(ArgParser* parser) {
  parser->Option("pixel-grid", {Choice("GRID", &grid_, {"corners", "centres"})},
                 "whether the positions of the outermost pixels lie on the edge of the view, as in "
                 "the course, or half a pixel inside (default corners, with integrators that draw "
                 "samples centres)",
                 kInFilm);
}

void PictureSettings::AddLight(ArgParser* parser, CommonOptions* common) {
  parser->Option("integrator", {Choice("NAME", &request_.integrator, IntegratorNames())},
                 IntegratorSummaries(), kInRender);
  common->AddLight(parser, "0, with path and light_trace as many as it takes");
  IntegratorOptions& light = request_.integrator_options;
  parser->Option(
      "diffuse-bounces", {Whole("N", &light.diffuse_bounces, 0)},
      "with path and light_trace: of the bounces, those by surfaces that scatter (default all)",
      kInRender);
  parser->Option("mirror-bounces", {Whole("N", &light.mirror_bounces, 0)},
                 "with path and light_trace: those by mirrors (default all)", kInRender);
  parser->Option("transmission-bounces", {Whole("N", &light.transmission_bounces, 0)},
                 "with path and light_trace: those through surfaces (default all)", kInRender);
  AddDistribution(parser);
  parser->Option("ao-distance", {Positive("X", &light.ao_distance)},
                 "with ambient_occlusion: what is farther away does not count (default all does)",
                 kInRender);
  parser->Option("view", {Choice("NAME", &view_, DebugViewNames())}, DebugViewSummaries(),
                 kInRender);
  parser->Option("light-choice", {Choice("NAME", &light_choice_, LightChoiceNames())},
                 LightChoiceSummaries(), kInRender);
}

void PictureSettings::AddDistribution(ArgParser* parser) {
  IntegratorOptions& light = request_.integrator_options;
  constexpr int64_t kMost = DistributionIntegrator::kMostRays;
  parser->Option("light-samples", {Whole("N", &light.light_samples, 0, kMost)},
                 "with whitted: rays to each area light, for soft shadows (default 0: area lights "
                 "light nothing)",
                 kInRender);
  parser->Option("glossy-samples", {Whole("N", &light.glossy_samples, 1, kMost)},
                 fmt::format("with whitted: rays of a reflection that the material spreads "
                             "(default {})",
                             DistributionIntegrator::kUsualGlossySamples),
                 kInRender);
  parser->Option("indirect-samples", {Whole("N", &light.indirect_samples, 0, kMost)},
                 "with whitted: rays that gather the light around a surface, in place of the "
                 "ambient light (default 0)",
                 kInRender);
  parser->Option("indirect-sampling", {Choice("NAME", &indirect_sampling_, {"cosine", "uniform"})},
                 "with whitted: how these are spread (default cosine)", kInRender);
  parser->Flag("depth-of-field", &light.depth_of_field,
               "with whitted: look through all of the lens of the camera, not its middle",
               kInRender);
}

void PictureSettings::AddSamples(ArgParser* parser) {
  parser->Option("samples", {Whole("N", &samples_, 1)},
                 fmt::format("samples of each pixel (default 1, with --filter {}, with integrators "
                             "that draw them {})",
                             kFilteredSamples, kPathSamples),
                 kInRender);
  stop_.Add(parser);
  parser->Option(
      "filter", {Choice("NAME", &filter_, FilterNames())},
      fmt::format("how samples are weighed: {} (default box)", fmt::join(FilterNames(), ", ")),
      kInFilm);
  parser->Option("sampler", {Choice("NAME", &sampler_, SamplerNames())}, SamplerSummaries(),
                 kInRender);
  parser->Option("clamp", {Positive("X", &request_.render.clamp)},
                 "darken samples of which a channel is above X, colour kept: less noise, but the "
                 "picture loses light, and it is said how much (default off)",
                 kInRender);
  parser->Flag("jitter", &jitter_,
               "the course's 4x4 samples of each pixel, with --filter tent weighed");
  parser->Option("seed", {Whole("N", &request_.render.seed, 0, 4294967295)},
                 "another number gives other random positions (default 0)", kInRender);
}

Result<void> PictureSettings::CheckJitter() const {
  if (jitter_ && samples_) return UsageError("--jitter and --samples: give one of them");
  if (jitter_ && filter_ && *filter_ != "tent") {
    return UsageError("--jitter goes with --filter tent only; use --samples with other filters");
  }
  return {};
}

Result<void> PictureSettings::CheckTone(const ArgParser& parser) const {
  for (const char* name :
       {"tonemap", "exposure", "iso", "f-stop", "shutter", "bloom", "vignette"}) {
    if (!parser.Has(name)) continue;
    if (!request_.output) {
      return UsageError(fmt::format("--{} is for the picture of --output: give both", name));
    }
    const bool is_for_all =
        std::string_view(name) == "bloom" || std::string_view(name) == "vignette";
    if (is_for_all || IsForDisplays(*FormatOf(*request_.output))) continue;
    return UsageError(
        fmt::format("--{} is for .png and .jpg files; the others hold the light itself", name));
  }
  return {};
}

Result<void> PictureSettings::CheckFilm(const ArgParser& parser) const {
  if (const auto done = exposure_.Check(parser); !done) return done;
  return lens_.Check(parser);
}

void PictureSettings::MergeFilm(const ArgParser& parser, const SceneSpec& spec,
                                Diagnostics* diagnostics) {
  exposure_.Merge(parser, spec.film.params, diagnostics);
  lens_.CheckScene(parser, spec, diagnostics);
}

void PictureSettings::DropSamplesOfScene(const ArgParser& parser) {
  if (!jitter_) return;
  samples_.reset();  // --samples cannot have been given.
  stop_.DropThoseOfScene(parser);
  if (!parser.Has("filter")) filter_.reset();
}

void PictureSettings::CheckForIntegrator(const ArgParser& parser, const ParamSet& settings,
                                         Diagnostics* diagnostics) {
  CheckClamp(parser, settings, diagnostics);
  stop_.CheckScene(parser, settings, sampler_, diagnostics);
  const IntegratorEntry& integrator = *FindIntegrator(request_.integrator);
  uint32_t uses = integrator.uses;
  std::string text = fmt::format("has no effect with the integrator '{}'", request_.integrator);
  if (integrator.Uses(kUsesView)) {
    const DebugViewEntry& view = view_ ? *FindDebugView(*view_) : DebugViews().front();
    if (!view.follows_light) {
      uses = kUsesView;
      text = fmt::format("has no effect with the view '{}'", view.name);
    }
  }
  const auto warn = [&](std::string_view option, std::string_view param) {
    const Param* in_scene = settings.Find(param);
    if (parser.Has(option)) {
      PrintWarning(parser.program(), fmt::format("{} {}", parser.Spell(option), text));
    } else if (in_scene) {
      diagnostics->Warning(in_scene->where, fmt::format("'{}' {}", param, text));
    }
  };
  IntegratorOptions& light = request_.integrator_options;
  const auto drop = [&](IntegratorUse use, std::string_view option, std::string_view param,
                        auto* value) {
    if ((uses & use) != 0 || !*value) return;
    warn(option, param);
    *value = {};
  };
  drop(kUsesShadows, "shadows", "shadows", &light.shadows);
  drop(kUsesBounces, "bounces", "bounces", &light.bounces);
  drop(kUsesBounceKinds, "diffuse-bounces", "diffuse_bounces", &light.diffuse_bounces);
  drop(kUsesBounceKinds, "mirror-bounces", "mirror_bounces", &light.mirror_bounces);
  drop(kUsesBounceKinds, "transmission-bounces", "transmission_bounces",
       &light.transmission_bounces);
  drop(kUsesDistribution, "light-samples", "light_samples", &light.light_samples);
  drop(kUsesDistribution, "glossy-samples", "glossy_samples", &light.glossy_samples);
  drop(kUsesDistribution, "indirect-samples", "indirect_samples", &light.indirect_samples);
  drop(kUsesDistribution, "indirect-sampling", "indirect_sampling", &indirect_sampling_);
  drop(kUsesDistribution, "depth-of-field", "depth_of_field", &light.depth_of_field);
  drop(kUsesAoDistance, "ao-distance", "ao_distance", &light.ao_distance);
  drop(kUsesView, "view", "view", &view_);
  drop(kUsesLightChoice, "light-choice", "light_choice", &light_choice_);
}

void PictureSettings::CheckClamp(const ArgParser& parser, const ParamSet& settings,
                                 Diagnostics* diagnostics) {
  const Param* clamp = settings.Find("clamp");
  if (!clamp || parser.Has("clamp")) return;
  if (!FindIntegrator(request_.integrator)->has_light_paths) return;
  const std::string text =
      fmt::format("what light paths of '{}' bring has no samples to clamp", request_.integrator);
  // No option could switch it off for whoever asks for light paths.
  if (parser.Has("integrator")) {
    diagnostics->Warning(clamp->where, "'clamp' has no effect: " + text);
  } else {
    diagnostics->Error(clamp->where, "'clamp': " + text);
  }
  request_.render.clamp.reset();
}

void PictureSettings::Finish() {
  FinishSamples();
  FinishGrid();
  FinishTone();
  auto& bounces = request_.integrator_options.bounces;
  if (request_.integrator == "whitted" && !bounces) bounces = WhittedIntegrator::kUsualBounces;
  FinishSampler();
  if (indirect_sampling_ == "uniform") {
    request_.integrator_options.indirect_sampling = IndirectSampling::kUniform;
  }
  FinishView();
  if (light_choice_) {
    request_.integrator_options.light_choice = FindLightChoice(*light_choice_)->choice;
  }
}

void PictureSettings::FinishSamples() {
  RenderOptions& render = request_.render;
  if (jitter_) {
    render.pattern = filter_ ? SamplePattern::kStrataTent : SamplePattern::kStrata;
    render.samples = kStrataSamples;
    return;
  }
  const uint32_t usual = IsSampled() ? kPathSamples : filter_ ? kFilteredSamples : 1;
  if (!samples_) samples_ = stop_.UsualSamples().value_or(usual);
  render.samples = *samples_;
  render.pattern = render.samples > 1 || filter_ ? SamplePattern::kFilter : SamplePattern::kCentre;
  if (render.pattern == SamplePattern::kCentre) return;
  if (!filter_) filter_ = "box";
  render.filter = *filter_;
}

void PictureSettings::FinishSampler() {
  RenderOptions& render = request_.render;
  render.sampler = SamplerType(FindSampler(sampler_)->kind, render.samples);
  render.drops_negative = IsSampled();
  request_.integrator_options.seed = render.seed;
  request_.integrator_options.sampler = render.sampler;
}

void PictureSettings::FinishView() {
  if (!FindIntegrator(request_.integrator)->Uses(kUsesView)) return;
  if (!view_) view_ = DebugViews().front().name;
  request_.integrator_options.view = FindDebugView(*view_)->view;
}

void PictureSettings::FinishGrid() {
  if (!grid_) grid_ = IsSampled() ? "centres" : "corners";
  request_.render.grid = *grid_ == "centres" ? PixelGrid::kCentres : PixelGrid::kCorners;
}

void PictureSettings::FinishTone() {
  if (!tonemap_) tonemap_ = IsSampled() ? "srgb" : "none";
  request_.output_options.lens = lens_.Effects();
  // Without curve and exposure the course's quantisation stays as it is.
  const bool is_plain =
      *tonemap_ == "none" && !exposure_.IsPhotographic() && exposure_.Stops() == 0;
  exposure_.Show(!is_plain);
  if (!is_plain) request_.output_options.tone = {FindToneCurve(*tonemap_), exposure_.Gain()};
}

bool PictureSettings::IsSampled() const {
  return FindIntegrator(request_.integrator)->is_sampled;
}

}  // namespace candela
