#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "base/result.h"
#include "integrators/integrator.h"
#include "scene/scene.h"

namespace candela {

struct IntegratorOptions;

/// Recursive ray tracing with the Phong model, exactly as the course has it: Whitted, "An Improved
/// Illumination Model for Shaded Display", 1980. Since a surface sends out one ray at most, the
/// recursion is a loop.
class WhittedIntegrator final : public Integrator {
 public:
  WhittedIntegrator(const Scene& scene, uint32_t bounces, bool shadows);
  static Result<std::unique_ptr<Integrator>> Create(const Scene& scene,
                                                    const IntegratorOptions& options);

  void Trace(std::span<const SampleRequest> samples, Workspace* workspace,
             std::span<Spectrum> radiance) const override;
  std::vector<std::string> Explain(const SampleRequest& sample) const override;

 private:
  /// Follows a camera ray. The observer is told of each hit, light and miss; see `RayStory`.
  template <class Observer>
  Rgb Follow(Ray ray, RayCounts* rays, Observer* observer) const;

  /// What the lights and the ambient light give at a point seen from the direction `eye`.
  template <class Observer>
  Rgb Shade(Vec3 p, Vec3 normal, Vec3 eye, const PhongTerms& terms, RayCounts* rays,
            Observer* observer) const;

  bool IsShadowed(Vec3 p, const LightSample& light, RayCounts* rays) const;

  const Scene& scene_;
  std::vector<const Light*> delta_lights_;
  uint32_t bounces_;
  bool shadows_;
};

}  // namespace candela
