#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "base/result.h"
#include "integrators/integrator.h"
#include "integrators/shutter_times.h"
#include "sampling/sampler.h"
#include "scene/scene.h"

namespace candela {

struct IntegratorOptions;

/// How much of the sky each surface sees, weighed by the cosine: white where nothing is in the way,
/// whatever the surface is made of. Zhukov, Iones and Kronin, "An Ambient Light Illumination
/// Model", 1998. Each sample follows one ray, drawn by the cosine, as far as is asked for.
class AmbientOcclusionIntegrator final : public Integrator {
 public:
  AmbientOcclusionIntegrator(const Scene& scene, const IntegratorOptions& options);
  static Result<std::unique_ptr<Integrator>> Create(const Scene& scene,
                                                    const IntegratorOptions& options);

  std::unique_ptr<Workspace> MakeWorkspace() const override;
  void Trace(std::span<const SampleRequest> samples, Workspace* workspace,
             const SampleOutput& output) const override;

 private:
  struct Batch;

  void Follow(std::span<const SampleRequest> samples, Batch* batch,
              const SampleOutput& output) const;

  const Scene& scene_;
  float distance_;  ///< What is farther away is not in the way.
  uint32_t seed_;
  SamplerType sampler_;
  ShutterTimes times_;
};

}  // namespace candela
