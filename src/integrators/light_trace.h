#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "base/result.h"
#include "geometry/ball.h"
#include "integrators/integrator.h"
#include "integrators/path.h"
#include "lights/light.h"
#include "sampling/alias_table.h"
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
class LightTraceIntegrator final : public Integrator {
 public:
  LightTraceIntegrator(const Scene& scene, const IntegratorOptions& options);
  /// Fails for materials that are not physical, and for light that cannot be sent out: of lamps
  /// without a sampler, and from the sky on surfaces without end.
  static Result<std::unique_ptr<Integrator>> Create(const Scene& scene,
                                                    const IntegratorOptions& options);

  std::unique_ptr<Workspace> MakeWorkspace() const override;
  void Trace(std::span<const SampleRequest> samples, Workspace* workspace,
             std::span<Spectrum> radiance) const override;
  /// False when nothing shines.
  bool TracesLightPaths() const override { return choice_.has_value(); }
  void TraceLightPaths(uint64_t first, uint64_t count, Workspace* workspace,
                       std::vector<Splat>* splats) const override;

 private:
  struct Path;
  struct Batch;

  /// Starts a path at a light. False when nothing was sent out.
  bool Emit(Path* path, Ray* ray) const;
  Rgb AbsorptionAround(Ray ray) const;

  // The stages of one bounce, as those of `PathIntegrator`.
  void Shade(uint32_t bounce, Batch* batch) const;
  void Connect(const Path& path, uint32_t bounce, const PathVertex& vertex, Batch* batch) const;
  void AddConnections(Batch* batch, std::vector<Splat>* splats) const;
  /// False when the path ends.
  bool Scatter(uint32_t bounce, const PathVertex& vertex, Path* path, Ray* ray) const;

  const Scene& scene_;
  PathIntegrator from_camera_;
  Ball ball_;
  std::unique_ptr<const Light> sky_;
  std::vector<const Light*> lights_;  ///< Those with power.
  std::vector<float> probabilities_;  ///< Of their choice, by power.
  std::optional<AliasTable> choice_;
  bool has_absorption_ = false;  ///< Whether any material absorbs light inside.
  uint32_t bounces_;
  std::array<uint32_t, 3> bounces_of_kind_;
  uint32_t seed_;
};

}  // namespace candela
