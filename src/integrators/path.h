#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>

#include "base/result.h"
#include "integrators/integrator.h"
#include "integrators/path_lights.h"
#include "integrators/path_state.h"
#include "integrators/path_techniques.h"
#include "integrators/shutter_times.h"
#include "sampling/sampler.h"
#include "scene/scene.h"

namespace candela {

struct BounceNumbers;
struct IntegratorOptions;
struct PathVertex;

/// Path tracing: Kajiya, "The Rendering Equation", 1986. At each hit one light is chosen and
/// sampled (next-event estimation); what rays find by chance is weighed against that, see
/// `PathLights`. Unbiased: long paths end by Russian roulette, not at a depth, unless a number of
/// bounces is asked for. Many paths are followed together, so that the search for what their rays
/// meet gets long lists.
class PathIntegrator final : public Integrator {
 public:
  PathIntegrator(const Scene& scene, const IntegratorOptions& options,
                 const PathTechniques& techniques = {});
  /// For scenes whose materials are all physical.
  static Result<std::unique_ptr<Integrator>> Create(const Scene& scene,
                                                    const IntegratorOptions& options);

  std::unique_ptr<Workspace> MakeWorkspace() const override;
  void Trace(std::span<const SampleRequest> samples, Workspace* workspace,
             const SampleOutput& output) const override;

 private:
  struct Batch;

  void Follow(std::span<const SampleRequest> samples, Batch* batch,
              const SampleOutput& output) const;

  // The stages of one step: what the rays have met is lit, in part, and sends out new rays; then
  // those shadow rays that reach their lights add to the sums.
  void Shade(uint32_t step, Batch* batch, const SampleOutput& output) const;
  void AddSampledLight(Batch* batch, const SampleOutput& output) const;

  void SampleLight(const PathState& path, const BounceNumbers& numbers, const PathVertex& vertex,
                   Batch* batch) const;
  /// Moves the point of a rounded mesh to where the round surface would be.
  void Lift(const HitRecord& hit, PathVertex* vertex) const;
  /// Whether the path goes on, and where.
  bool Scatter(uint32_t step, const BounceNumbers& numbers, const PathVertex& vertex,
               PathState* path, Ray* ray) const;

  const Scene& scene_;
  PathLights lights_;
  MediumStack media_at_camera_;
  bool starts_in_one_place_;  ///< At all times. If not, the media have to be found for each ray.
  BounceLimits limits_;
  uint32_t seed_;
  SamplerType sampler_;
  ShutterTimes times_;
  bool has_roulette_, has_lift_, beyond_light_paths_;
};

}  // namespace candela
