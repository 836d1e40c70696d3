#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "base/result.h"
#include "integrators/integrator.h"
#include "sampling/sampler.h"
#include "scene/scene.h"

namespace candela {

/// What the command line says about light transport.
struct IntegratorOptions {
  /// Reflections after the camera ray; without a value each integrator has a default of its own.
  std::optional<uint32_t> bounces;
  /// For `path` and `light_trace`, of these bounces: those by surfaces that scatter, by mirrors,
  /// and through surfaces. Unlimited without a value.
  std::optional<uint32_t> diffuse_bounces, mirror_bounces, transmission_bounces;
  bool shadows = false;  ///< For `whitted`: lights are blocked by objects.
  uint32_t seed = 0;
  SamplerType sampler;  ///< Where the random numbers come from.
};

/// An integrator that may be asked for by name.
struct IntegratorEntry {
  std::string_view name;
  std::string_view description;  ///< For the help.
  /// Fails when the scene holds what the integrator does not know.
  Result<std::unique_ptr<Integrator>> (*create)(const Scene& scene,
                                                const IntegratorOptions& options);
  bool is_physical;      ///< Solves light transport; the contract tests hold it to a furnace.
  bool has_layers;       ///< Fills in `SampleOutput::layers`.
  bool has_light_paths;  ///< Light lands in pixels from paths that begin at lamps.
};

std::span<const IntegratorEntry> IntegratorEntries();

/// The row of that name, or null.
const IntegratorEntry* FindIntegrator(std::string_view name);

/// Creates the integrator `name` for a scene, which has to outlive it.
Result<std::unique_ptr<Integrator>> CreateIntegrator(std::string_view name, const Scene& scene,
                                                     const IntegratorOptions& options);

}  // namespace candela
