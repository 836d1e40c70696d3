#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "integrators/integrator.h"
#include "integrators/registry.h"
#include "integrators/shutter_times.h"
#include "sampling/sampler.h"
#include "scene/scene.h"

namespace candela {

/// `WhittedIntegrator` where one ray is not enough: Cook, Porter and Carpenter, "Distributed Ray
/// Tracing", 1984. Lamps with a surface throw soft shadows, reflections are spread, surfaces
/// refract, light is gathered from all around a surface, the lens has an opening, and there is fog.
/// Where a scene and its options ask for none of that the picture is the other's, bit by bit.
///
/// Of each sample a tree of rays is followed, level by level, many samples together. It is bounded:
/// a surface sends out several rays of a kind only when it was not found by one of several, and
/// beyond a few surfaces where light is both reflected and refracted one of the two is drawn.
class DistributionIntegrator final : public Integrator {
 public:
  /// Rays of a reflection that is spread, where nobody says how many.
  static constexpr uint32_t kUsualGlossySamples = 16;
  /// So many rays of a kind may be asked for: what waits on one level has to fit into memory.
  static constexpr uint32_t kMostRays = 4096;

  DistributionIntegrator(const Scene& scene, const IntegratorOptions& options);

  /// Whether the scene or the options ask for what one ray cannot do.
  static bool IsNeeded(const Scene& scene, const IntegratorOptions& options);

  std::unique_ptr<Workspace> MakeWorkspace() const override;
  void Trace(std::span<const SampleRequest> samples, Workspace* workspace,
             const SampleOutput& output) const override;

 private:
  struct TreeRay;
  struct Shading;
  struct Batch;

  void Follow(std::span<const SampleRequest> samples, Batch* batch,
              const SampleOutput& output) const;
  void StartRays(Batch* batch, const SampleOutput& output) const;

  // The stages of one level of the trees, in this order.
  void EndMisses(Batch* batch, const SampleOutput& output) const;
  void RecordSurfaces(Batch* batch, const SampleOutput& output) const;
  void FindSurfaces(Batch* batch, const SampleOutput& output) const;
  void AddSharpLight(const Light& light, RayOrder order, Batch* batch) const;
  void AddLamp(uint32_t light, Batch* batch) const;
  void AddOwnLight(Batch* batch, const SampleOutput& output) const;
  void GoOn(Batch* batch) const;

  /// What the way to a hit or to nothing takes away, and what fog adds.
  void Travel(const Ray& ray, double distance, Batch* batch, const SampleOutput& output,
              TreeRay* path) const;
  /// The light of the object itself.
  Rgb Emitted(uint32_t light, const TreeRay& path, const Shading& shading) const;
  void Gather(const TreeRay& path, const Shading& shading, Batch* batch) const;
  void Reflect(const TreeRay& path, const Ray& ray, const Shading& shading, Rgb weight,
               Batch* batch) const;

  /// Whether rays gather the light around what this ray has met.
  bool Gathers(const TreeRay& path, const Shading& shading) const;
  uint32_t GlossySamples() const { return options_.glossy_samples.value_or(kUsualGlossySamples); }
  /// One of `count` rays that go on from a ray, by its number.
  TreeRay ChildOf(const TreeRay& path, uint32_t branch, uint32_t count, uint32_t number,
                  const Batch& batch) const;

  const Scene& scene_;
  IntegratorOptions options_;
  std::vector<const Light*> sharp_lights_;
  std::vector<uint32_t> lamps_;  ///< Those with a surface that can be sampled, by their number.
  ShutterTimes times_;
  uint32_t bounces_;
  size_t together_;  ///< So many samples are followed together.
};

}  // namespace candela
