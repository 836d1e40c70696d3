#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "base/result.h"
#include "integrators/integrator.h"
#include "integrators/shutter_times.h"
#include "sampling/sampler.h"
#include "scene/scene.h"

namespace candela {

struct IntegratorOptions;

/// Recursive ray tracing with the Phong model, exactly as the course has it: Whitted, "An Improved
/// Illumination Model for Shaded Display", 1980. Since a surface sends out one ray at most, the
/// recursion is a loop, which many samples go through together: all of them look for their hits,
/// then for the shadows of one light after the other, then go on along their mirrored rays.
class WhittedIntegrator final : public Integrator {
 public:
  /// Reflections where nobody says how many.
  static constexpr uint32_t kUsualBounces = 0;

  /// Seed and sampler are for the times of samples, when something moves.
  WhittedIntegrator(const Scene& scene, uint32_t bounces, bool shadows, uint32_t seed = 0,
                    SamplerType sampler = {});
  /// What a scene or options need beyond that is a `DistributionIntegrator`'s.
  static Result<std::unique_ptr<Integrator>> Create(const Scene& scene,
                                                    const IntegratorOptions& options);

  std::unique_ptr<Workspace> MakeWorkspace() const override;
  void Trace(std::span<const SampleRequest> samples, Workspace* workspace,
             const SampleOutput& output) const override;
  std::vector<std::string> Explain(const SampleRequest& sample) const override;

 private:
  struct Batch;

  /// Follows samples to their ends. The observer is told of each hit, light and miss, in order when
  /// there is one sample; see `RayStory`.
  template <class Observer>
  void Follow(std::span<const SampleRequest> samples, Batch* batch, const SampleOutput& output,
              Observer* observer) const;

  // The stages of one bounce, in this order.
  template <class Observer>
  void EndMisses(uint32_t bounce, Batch* batch, const SampleOutput& output,
                 Observer* observer) const;
  void RecordSurfaces(Batch* batch, const SampleOutput& output) const;
  template <class Observer>
  void FindSurfaces(Batch* batch, Observer* observer) const;
  void FindShadows(const Light& light, RayOrder order, Batch* batch) const;
  template <class Observer>
  void AddLight(const Light& light, Batch* batch, Observer* observer) const;
  template <class Observer>
  void Reflect(uint32_t bounce, Batch* batch, const SampleOutput& output, Observer* observer) const;

  const Scene& scene_;
  std::vector<const Light*> sharp_lights_;
  uint32_t bounces_;
  bool shadows_;
  ShutterTimes times_;
};

}  // namespace candela
