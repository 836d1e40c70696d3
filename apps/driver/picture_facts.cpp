#include "driver/picture_facts.h"

#include <fmt/format.h>

// The functions themselves instead of a library that has to be found.
#define XXH_INLINE_ALL
#include <xxhash.h>

#include "base/files.h"
#include "driver/picture_files.h"
#include "sampling/sampler.h"
#include "scene/input_files.h"

namespace candela {
namespace {

std::string_view PatternName(SamplePattern pattern) {
  switch (pattern) {
    case SamplePattern::kCentre:
      return "centre";
    case SamplePattern::kStrata:
      return "jitter";
    case SamplePattern::kStrataTent:
      return "jitter_tent";
    case SamplePattern::kFilter:
      return "filter";
  }
  return "";
}

std::string_view NameOf(DebugView view) {
  for (const DebugViewEntry& entry : DebugViews()) {
    if (entry.view == view) return entry.name;
  }
  return "";
}

std::string SamplerName(SamplerType type) {
  for (const SamplerEntry& entry : Samplers()) {
    if (entry.kind != type.kind) continue;
    const bool is_made_for_a_number = type.kind == SamplerKind::kBlueNoise;
    return is_made_for_a_number ? fmt::format("{}/{}", entry.name, 1 << type.log2_samples)
                                : std::string(entry.name);
  }
  return {};
}

}  // namespace

Result<std::string> HashScene(const SceneSpec& spec) {
  uint64_t hash = 0;
  for (const auto& path : ContentFiles(spec)) {
    const Result<std::string> bytes = ReadFile(path);
    if (!bytes) return WithPath(path, bytes.error());
    // The hash of the files before is the seed, and the size is a part of XXH3.
    hash = XXH3_64bits_withSeed(bytes->data(), bytes->size(), hash);
  }
  return fmt::format("{:016x}", hash);
}

std::string PictureOptions(const RenderRequest& request) {
  const RenderOptions& render = request.render;
  const IntegratorOptions& light = request.integrator_options;
  std::string options =
      fmt::format("--size {} {} --crop {} {} {} {} --pixel-grid {} --integrator {}", render.width,
                  render.height, render.crop.x0, render.crop.y0, render.crop.x1, render.crop.y1,
                  render.grid == PixelGrid::kCorners ? "corners" : "centres", request.integrator);
  if (render.stretch) options += " --stretch";
  const auto add = [&options](std::string_view name, const std::optional<uint32_t>& value) {
    if (value) options += fmt::format(" --{} {}", name, *value);
  };
  add("bounces", light.bounces);
  add("diffuse-bounces", light.diffuse_bounces);
  add("mirror-bounces", light.mirror_bounces);
  add("transmission-bounces", light.transmission_bounces);
  if (light.shadows) options += " --shadows";
  add("light-samples", light.light_samples);
  add("glossy-samples", light.glossy_samples);
  add("indirect-samples", light.indirect_samples);
  if (light.indirect_sampling == IndirectSampling::kUniform) {
    options += " --indirect-sampling uniform";
  }
  if (light.depth_of_field) options += " --depth-of-field";
  if (light.ao_distance) options += fmt::format(" --ao-distance {}", *light.ao_distance);
  if (FindIntegrator(request.integrator)->Uses(kUsesView)) {
    options += fmt::format(" --view {}", NameOf(light.view));
  }
  if (light.light_choice != LightChoice::kByEffect) {
    options += fmt::format(" --light-choice {}", EntryOf(light.light_choice).name);
  }
  if (render.pattern == SamplePattern::kFilter) {
    options += fmt::format(" --filter {}", render.filter);
  } else {
    options += fmt::format(" ({})", PatternName(render.pattern));
  }
  options += fmt::format(" --sampler {} --seed {}", SamplerName(render.sampler), render.seed);
  if (render.clamp) options += fmt::format(" --clamp {}", *render.clamp);
  return options;
}

namespace {

/// What else is done to the colours, when they are written.
std::string LensText(const LensEffects& lens) {
  std::string text;
  if (lens.HasBloom()) {
    text += fmt::format(" --bloom {} {}", lens.bloom_strength, lens.bloom_radius);
  }
  if (lens.vignette > 0) text += fmt::format(" --vignette {}", lens.vignette);
  return text;
}

/// When the work ends, if not with the samples.
std::string StopText(const RenderOptions& render) {
  std::string text;
  if (render.noise_target) text += fmt::format(" --noise-target {}", *render.noise_target);
  if (render.time_limit) text += fmt::format(" --time-limit {}", *render.time_limit);
  return text;
}

}  // namespace

CheckpointOwner OwnerOfCheckpoint(const RenderRequest& request, std::string scene_hash) {
  return {CANDELA_VERSION, std::move(scene_hash), PictureOptions(request)};
}

std::vector<ExrAttribute> PictureAttributes(const RenderRequest& request,
                                            const std::string& scene_hash) {
  return {{"software", "Candela " CANDELA_VERSION},
          {"candela/scene_hash", scene_hash},
          {"candela/integrator", request.integrator},
          {"candela/samples", std::to_string(request.render.samples)},
          {"candela/seed", std::to_string(request.render.seed)},
          {"candela/options", PictureOptions(request) + StopText(request.render) +
                                  LensText(request.output_options.lens)}};
}

}  // namespace candela
