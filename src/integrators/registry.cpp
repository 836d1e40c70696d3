#include "integrators/registry.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "base/text.h"
#include "integrators/ambient_occlusion.h"
#include "integrators/light_trace.h"
#include "integrators/path.h"
#include "integrators/physical_scene.h"
#include "integrators/whitted.h"

namespace candela {
namespace {

void CheckForPath(const Scene& scene, Diagnostics* diagnostics) {
  CheckPhysical(scene, "path", diagnostics);
}

void CheckForDirect(const Scene& scene, Diagnostics* diagnostics) {
  CheckPhysical(scene, "direct", diagnostics);
}

void CheckForAmbientOcclusion(const Scene& scene, Diagnostics* diagnostics) {
  if (!scene.fog()) return;
  diagnostics->Warning(scene.PlaceOfFog(),
                       "the fog has no effect with the integrator 'ambient_occlusion'");
}

/// A path of one bounce is all of it: at the surface that the camera sees a light is sampled, and
/// the bounce finds what shines; each is weighed against the other.
Result<std::unique_ptr<Integrator>> CreateDirect(const Scene& scene,
                                                 const IntegratorOptions& options) {
  IntegratorOptions one_bounce = options;
  one_bounce.bounces = 1;
  return PathIntegrator::Create(scene, one_bounce);
}

constexpr IntegratorEntry kIntegrators[] = {
    {"whitted", "the course's: Phong shading, mirrors, shadows", nullptr,
     &WhittedIntegrator::Create, false, true, false, false,
     kUsesBounces | kUsesShadows | kUsesDistribution},
    {"path",
     "path tracing: light as it is, with all lights and all materials but Phong "
     "highlights that are not normalised",
     &CheckForPath, &PathIntegrator::Create, true, true, false, true,
     kUsesBounces | kUsesBounceKinds | kUsesLightChoice, true},
    {"light_trace", "the same light, followed from the lights to the camera",
     &LightTraceIntegrator::Check, &LightTraceIntegrator::Create, true, false, true, true,
     kUsesBounces | kUsesBounceKinds | kUsesLightChoice},
    {"direct",
     "what shines, and what it lights without a detour: path tracing of one bounce, mirrors "
     "included",
     &CheckForDirect, &CreateDirect, false, true, false, true, kUsesLightChoice, true},
    {"ambient_occlusion", "how much of the sky each surface sees", &CheckForAmbientOcclusion,
     &AmbientOcclusionIntegrator::Create, false, false, false, true, kUsesAoDistance},
    {"debug", "what a renderer works with, as --view says", nullptr, &DebugIntegrator::Create,
     false, false, false, false,
     kUsesBounces | kUsesBounceKinds | kUsesShadows | kUsesDistribution | kUsesView |
         kUsesLightChoice},
};

}  // namespace

std::span<const IntegratorEntry> IntegratorEntries() {
  return kIntegrators;
}

const IntegratorEntry* FindIntegrator(std::string_view name) {
  const auto found = std::ranges::find(kIntegrators, name, &IntegratorEntry::name);
  return found == std::end(kIntegrators) ? nullptr : found;
}

void CheckForIntegrator(std::string_view name, const Scene& scene, Diagnostics* diagnostics) {
  const IntegratorEntry* entry = FindIntegrator(name);
  CHECK(entry);
  if (entry->check) entry->check(scene, diagnostics);
}

Result<std::unique_ptr<Integrator>> CreateIntegrator(std::string_view name, const Scene& scene,
                                                     const IntegratorOptions& options) {
  if (const IntegratorEntry* entry = FindIntegrator(name)) {
    Diagnostics found;
    CheckForIntegrator(name, scene, &found);
    if (const auto is_fit = found.FirstError(); !is_fit) return is_fit.error();
    return entry->create(scene, options);
  }
  std::vector<std::string_view> names;
  for (const IntegratorEntry& entry : kIntegrators) names.push_back(entry.name);
  return Error{ErrorCode::kUsage, fmt::format("there is no integrator {}{}; known: {}", Quote(name),
                                              DidYouMean(name, names), ListOf(names))};
}

}  // namespace candela
