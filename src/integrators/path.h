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
/// Russian roulette, not at a depth, unless a number of bounces is asked for. Many paths are
/// followed together, so that the search for what their rays meet gets long lists.
class PathIntegrator final : public Integrator {
 public:
  PathIntegrator(const Scene& scene, const IntegratorOptions& options);
  /// Fails for materials that are not physical.
  static Result<std::unique_ptr<Integrator>> Create(const Scene& scene,
                                                    const IntegratorOptions& options);

  std::unique_ptr<Workspace> MakeWorkspace() const override;
  void Trace(std::span<const SampleRequest> samples, Workspace* workspace,
             std::span<Spectrum> radiance) const override;

 private:
  struct Batch;

  void Follow(std::span<const SampleRequest> samples, Batch* batch,
              std::span<Spectrum> radiance) const;

  // The stages of one bounce, in this order.
  void FindVertices(uint32_t bounce, Batch* batch, std::span<Spectrum> radiance) const;
  void AddLight(const Light& light, Batch* batch) const;
  void Scatter(uint32_t bounce, Batch* batch, std::span<Spectrum> radiance) const;

  const Scene& scene_;
  std::vector<const Light*> delta_lights_;
  uint32_t bounces_;
  uint32_t seed_;
};

}  // namespace candela
