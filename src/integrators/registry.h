#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "base/diagnostics.h"
#include "base/result.h"
#include "integrators/debug_view.h"
#include "integrators/integrator.h"
#include "lights/light_choice.h"
#include "sampling/sampler.h"
#include "scene/scene.h"

namespace candela {

/// How `whitted` draws directions to gather light from. The mean is the same.
enum class IndirectSampling {
  kCosine,   ///< By the cosine to the normal, by which they count.
  kUniform,  ///< All alike.
};

/// What the command line says about light transport.
struct IntegratorOptions {
  /// Reflections after the camera ray; without a value each integrator has a default of its own.
  std::optional<uint32_t> bounces;
  /// For `path` and `light_trace`, of these bounces: those by surfaces that scatter, by mirrors,
  /// and through surfaces. Unlimited without a value.
  std::optional<uint32_t> diffuse_bounces, mirror_bounces, transmission_bounces;
  bool shadows = false;  ///< For `whitted`: lights are blocked by objects.
  // For `whitted`, see `DistributionIntegrator`.
  /// Rays to each lamp with a surface; without a value such lamps light nothing.
  std::optional<uint32_t> light_samples;
  std::optional<uint32_t> glossy_samples;  ///< Rays of a reflection that is spread.
  /// Rays that gather the light around a surface; without a value none.
  std::optional<uint32_t> indirect_samples;
  IndirectSampling indirect_sampling = IndirectSampling::kCosine;
  bool depth_of_field = false;  ///< Rays go through all of the lens, not its middle.
  /// For `ambient_occlusion`: what is farther away is not in the way. Nothing without a value.
  std::optional<float> ao_distance;
  /// For `path`, `direct` and `light_trace`: how a light is chosen to be sampled.
  LightChoice light_choice = LightChoice::kByEffect;
  DebugView view = DebugView::kNormal;  ///< For `debug`.
  uint32_t seed = 0;
  SamplerType sampler;  ///< Where the random numbers come from.
};

/// Options that an integrator knows, as bits of a set; the others have no effect.
enum IntegratorUse : uint32_t {
  kUsesBounces = 1,
  kUsesBounceKinds = 2,
  kUsesShadows = 4,
  kUsesAoDistance = 8,
  kUsesView = 16,
  kUsesDistribution = 32,  ///< From `light_samples` to `depth_of_field`.
  kUsesLightChoice = 64,
};

/// An integrator that may be asked for by name.
struct IntegratorEntry {
  std::string_view name;
  std::string_view description;  ///< For the help.
  /// Reports what the scene holds that the integrator does not know, with its places; null for one
  /// that knows everything.
  void (*check)(const Scene& scene, Diagnostics* diagnostics);
  /// For scenes of which nothing was reported.
  Result<std::unique_ptr<Integrator>> (*create)(const Scene& scene,
                                                const IntegratorOptions& options);
  bool is_physical;      ///< Solves light transport; the contract tests hold it to a furnace.
  bool has_layers;       ///< Fills in `SampleOutput::layers`.
  bool has_light_paths;  ///< Light lands in pixels from paths that begin at lamps.
  /// Its samples are drawn and never negative: a pixel is their mean, which takes many of them.
  bool is_sampled;
  uint32_t uses;                  ///< A set of `IntegratorUse`.
  bool has_light_groups = false;  ///< Fills in `SampleOutput::group_light`.

  bool Uses(IntegratorUse option) const { return (uses & option) != 0; }
};

std::span<const IntegratorEntry> IntegratorEntries();

/// The row of that name, or null.
const IntegratorEntry* FindIntegrator(std::string_view name);

/// Reports what keeps the integrator `name`, which there has to be, from a scene.
void CheckForIntegrator(std::string_view name, const Scene& scene, Diagnostics* diagnostics);

/// Creates the integrator `name` for a scene, which has to outlive it. Fails with the first thing
/// that keeps it from the scene.
Result<std::unique_ptr<Integrator>> CreateIntegrator(std::string_view name, const Scene& scene,
                                                     const IntegratorOptions& options);

}  // namespace candela
