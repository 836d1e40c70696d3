#include "candela/stop_settings.h"

#include <fmt/format.h>

#include <string>

#include "integrators/registry.h"
#include "sampling/sampler.h"

namespace candela {
namespace {

constexpr ArgTraits kInRender{.block = "Render"};
constexpr uint32_t kMostSamples = 65536;

/// Why pictures of the integrator cannot stop when something is reached; empty if they can.
std::string WhyNot(std::string_view integrator) {
  if (!FindIntegrator(integrator)->has_light_paths) return {};
  return fmt::format("how many light paths '{}' follows is known before it begins", integrator);
}

/// Why a picture cannot stop for its noise; empty if it can.
std::string WhyNoNoise(const RenderRequest& request, const SamplerEntry& sampler) {
  if (const std::string why = WhyNot(request.integrator); !why.empty()) return why;
  if (request.checkpoint) return "a checkpoint holds pixels that all have as many samples";
  if (sampler.has_independent_pixels) return {};
  return fmt::format("the noise of pixels with the sampler '{}' depends on their neighbours",
                     sampler.name);
}

}  // namespace

void StopSettings::Add(ArgParser* parser) {
  parser->Option("noise-target", {Positive("X", &request_.render.noise_target)},
                 "give pixels samples until 95 % of them have a standard error below X times their "
                 "brightness, in blocks of 16 x 16 pixels, or --samples of them (then the default "
                 "is 65536)",
                 kInRender);
  parser->Option("time-limit", {NotNegative("SECONDS", &request_.render.time_limit)},
                 "render until so many seconds are over, or --samples of each pixel are done (then "
                 "the default is 65536); how many there are depends on the machine",
                 kInRender);
}

void StopSettings::DropThoseOfScene(const ArgParser& parser) {
  if (!parser.Has("noise-target")) request_.render.noise_target.reset();
  if (!parser.Has("time-limit")) request_.render.time_limit.reset();
}

void StopSettings::CheckScene(const ArgParser& parser, const ParamSet& settings,
                              std::string_view sampler, Diagnostics* diagnostics) {
  const auto check = [&](std::string_view option, std::string_view name, const std::string& why,
                         auto* value) {
    const Param* param = settings.Find(name);
    if (!*value || why.empty() || !param || parser.Has(option)) return;
    // No option could switch it off for whoever asks for what does not go with it.
    if (parser.Has("integrator") || parser.Has("sampler") || parser.Has("checkpoint")) {
      diagnostics->Warning(param->where, fmt::format("'{}' has no effect: {}", name, why));
    } else {
      diagnostics->Error(param->where, fmt::format("'{}': {}", name, why));
    }
    value->reset();
  };
  check("noise-target", "noise_target", WhyNoNoise(request_, *FindSampler(sampler)),
        &request_.render.noise_target);
  check("time-limit", "time_limit", WhyNot(request_.integrator), &request_.render.time_limit);
}

Result<void> StopSettings::Check(const ArgParser& parser) const {
  const RenderOptions& render = request_.render;
  if (render.pattern == SamplePattern::kStrata || render.pattern == SamplePattern::kStrataTent) {
    for (const char* name : {"noise-target", "time-limit"}) {
      if (!parser.Has(name)) continue;
      return UsageError(fmt::format("--jitter and --{}: give one of them", name));
    }
  }
  if (render.noise_target) {
    for (const SamplerEntry& sampler : Samplers()) {
      if (sampler.kind != render.sampler.kind) continue;
      const std::string why = WhyNoNoise(request_, sampler);
      if (!why.empty()) return UsageError("--noise-target: " + why);
    }
  }
  const std::string why = WhyNot(request_.integrator);
  if (render.time_limit && !why.empty()) return UsageError("--time-limit: " + why);
  return {};
}

std::optional<uint32_t> StopSettings::UsualSamples() const {
  if (!request_.render.noise_target && !request_.render.time_limit) return std::nullopt;
  return kMostSamples;
}

}  // namespace candela
