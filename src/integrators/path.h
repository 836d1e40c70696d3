#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "base/result.h"
#include "integrators/integrator.h"
#include "scene/scene.h"

namespace candela {

struct IntegratorOptions;

/// Path tracing: Kajiya, "The Rendering Equation", 1986. Lights without extent are sampled at each
/// hit; surfaces that shine and the background are found by the paths. Unbiased: long paths end by
/// Russian roulette, not at a depth, unless a number of bounces is asked for.
class PathIntegrator final : public Integrator {
 public:
  PathIntegrator(const Scene& scene, const IntegratorOptions& options);
  /// Fails for materials that are not physical.
  static Result<std::unique_ptr<Integrator>> Create(const Scene& scene,
                                                    const IntegratorOptions& options);

  void Trace(std::span<const SampleRequest> samples, Workspace* workspace,
             std::span<Spectrum> radiance) const override;

 private:
  Spectrum Radiance(const SampleRequest& sample, RayCounts* rays) const;
  Spectrum DirectLight(const SurfacePoint& point, const Bsdf& bsdf, Vec3 wo, RayCounts* rays) const;

  const Scene& scene_;
  std::vector<const Light*> delta_lights_;
  uint32_t bounces_;
  uint32_t seed_;
};

}  // namespace candela
