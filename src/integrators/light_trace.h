#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "base/diagnostics.h"
#include "base/result.h"
#include "geometry/ball.h"
#include "integrators/integrator.h"
#include "integrators/path.h"
#include "integrators/shutter_times.h"
#include "lights/light.h"
#include "sampling/alias_table.h"
#include "sampling/sampler.h"
#include "scene/scene.h"

namespace candela {

struct IntegratorOptions;
struct PathVertex;

/// Light tracing: paths go from lights through the scene, and each surface that they meet is
/// connected to the camera: Arvo, "Backward Ray Tracing", 1986; Dutre, Lafortune and Willems,
/// "Monte Carlo Light Tracing with Direct Computation of Pixel Intensities", 1993. What cannot be
/// connected comes by the paths of `PathIntegrator` from the camera: lights that it sees directly,
/// and what it sees in mirrors and through glass. Together they solve the same transport as that
/// one, by other means: caustics come quickly, and large scenes of which little is seen slowly.
///
/// What differs: points of meshes with smooth normals are not lifted (`PathTechniques::lift`),
/// light that comes to such a mesh along its outline counts a little less, and light paths look at
/// textures unfiltered.
class LightTraceIntegrator final : public Integrator {
 public:
  LightTraceIntegrator(const Scene& scene, const IntegratorOptions& options);
  /// Reports materials that are not physical, bodies that look different from where light comes
  /// (see `CheckMediaAreSymmetric`), and light that cannot be sent out: of lamps without a sampler,
  /// and from the sky on surfaces without end.
  static void Check(const Scene& scene, Diagnostics* diagnostics);
  /// For scenes that pass the check.
  static Result<std::unique_ptr<Integrator>> Create(const Scene& scene,
                                                    const IntegratorOptions& options);

  std::unique_ptr<Workspace> MakeWorkspace() const override;
  void Trace(std::span<const SampleRequest> samples, Workspace* workspace,
             const SampleOutput& output) const override;
  /// False when nothing shines.
  bool TracesLightPaths() const override { return choice_.has_value(); }
  void TraceLightPaths(uint64_t first, uint64_t count, Workspace* workspace,
                       std::vector<Splat>* splats) const override;

 private:
  struct Path;
  struct Batch;

  /// Starts a path at a light. False when nothing was sent out.
  bool Emit(Path* path, Ray* ray) const;

  // The stages of one step, as those of `PathIntegrator`.
  void Shade(uint32_t step, Batch* batch) const;
  void Connect(const Path& path, uint32_t step, const PathVertex& vertex, Batch* batch) const;
  void AddConnections(Batch* batch, std::vector<Splat>* splats) const;
  /// Whether the path goes on, and where.
  bool Scatter(uint32_t step, const PathVertex& vertex, Path* path, Ray* ray) const;

  const Scene& scene_;
  PathIntegrator from_camera_;
  Ball ball_;
  std::unique_ptr<const Light> sky_;
  std::vector<const Light*> lights_;  ///< Those with power.
  std::vector<float> probabilities_;  ///< Of their choice, by power.
  std::optional<AliasTable> choice_;
  bool has_media_;  ///< Whether it counts in which bodies light is.
  BounceLimits limits_;
  uint32_t seed_;
  SamplerType sampler_;
  ShutterTimes times_;
};

}  // namespace candela
