#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "base/result.h"
#include "integrators/integrator.h"
#include "lights/environment_light.h"
#include "lights/light_picker.h"
#include "scene/scene.h"

namespace candela {

struct IntegratorOptions;
struct PathVertex;

/// How `PathIntegrator` looks for light. All ways have the same mean: they are there for tests and
/// comparisons.
struct PathTechniques {
  /// How what a sampled light gives and what a ray finds are combined, where both can be the same.
  enum class Weights { kPowerHeuristic, kBalanceHeuristic };

  bool next_event = true;  ///< Lights that rays can find are sampled as well.
  bool roulette = true;    ///< Long paths may end early.
  /// Only what light paths cannot bring to the camera: lights that it sees directly, and what the
  /// surface that it sees sends on in a single direction. This changes the mean.
  bool beyond_light_paths = false;
  Weights weights = Weights::kPowerHeuristic;
  LightChoice light_choice = LightChoice::kByEffect;
};

/// Path tracing: Kajiya, "The Rendering Equation", 1986. At each hit one light is chosen and
/// sampled (next-event estimation); what rays find by chance is weighed against that: Veach,
/// "Optimally Combining Sampling Techniques for Monte Carlo Rendering", 1995. Unbiased: long paths
/// end by Russian roulette, not at a depth, unless a number of bounces is asked for. Many paths are
/// followed together, so that the search for what their rays meet gets long lists.
class PathIntegrator final : public Integrator {
 public:
  PathIntegrator(const Scene& scene, const IntegratorOptions& options,
                 const PathTechniques& techniques = {});
  /// Fails for materials that are not physical.
  static Result<std::unique_ptr<Integrator>> Create(const Scene& scene,
                                                    const IntegratorOptions& options);

  std::unique_ptr<Workspace> MakeWorkspace() const override;
  void Trace(std::span<const SampleRequest> samples, Workspace* workspace,
             std::span<Spectrum> radiance) const override;

 private:
  struct Path;
  struct Batch;

  void Follow(std::span<const SampleRequest> samples, Batch* batch,
              std::span<Spectrum> radiance) const;

  // The stages of one bounce: what the rays have met is lit, in part, and sends out new rays; then
  // those shadow rays that reach their lights add to the sums.
  void Shade(uint32_t bounce, Batch* batch, std::span<Spectrum> radiance) const;
  void AddSampledLight(Batch* batch, std::span<Spectrum> radiance) const;

  Spectrum FromSky(const Path& path, Vec3 direction) const;
  Spectrum FromSurface(const Path& path, const SurfacePoint& point, Vec3 wo, uint32_t light) const;
  float WeightOfFound(const Path& path, uint32_t light, const SurfacePoint& point, Vec3 w) const;
  void SampleLight(const Path& path, uint32_t bounce, const PathVertex& vertex, Batch* batch) const;
  /// False when the path ends.
  bool Scatter(uint32_t bounce, const PathVertex& vertex, Path* path, Ray* ray) const;
  float Weight(float pdf, float other_pdf) const;

  const Scene& scene_;
  std::unique_ptr<const EnvironmentLight> environment_;
  std::vector<const Light*>
      lights_;                  ///< Those of the scene at their indices, then the environment.
  std::vector<uint32_t> suns_;  ///< Those of the scene that rays can find in the sky.
  LightPicker picker_;
  uint32_t bounces_;
  std::array<uint32_t, 3> bounces_of_kind_;
  uint32_t seed_;
  PathTechniques techniques_;
};

}  // namespace candela
