#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string_view>

#include "base/result.h"
#include "integrators/integrator.h"
#include "integrators/shutter_times.h"
#include "scene/scene.h"

namespace candela {

struct IntegratorOptions;

/// What `DebugIntegrator` shows.
enum class DebugView : uint8_t {
  kNormal,
  kGeometricNormal,
  kUv,
  kAlbedo,
  kObjectId,
  kMaterialId,
  kDepth,
  kBounces,
  kCost,
};

/// A row of the table of views.
struct DebugViewEntry {
  std::string_view name;
  std::string_view description;
  DebugView view;
  bool follows_light = false;  ///< It shows what another integrator does, by its options.
};

/// All of them, in the order of the manual.
std::span<const DebugViewEntry> DebugViews();

/// The row of that name, or null.
const DebugViewEntry* FindDebugView(std::string_view name);

/// Shows what a renderer works with in place of the light: what the camera's ray meets first, or
/// what it takes to follow it. What misses shows the background, except where effort is shown.
class DebugIntegrator final : public Integrator {
 public:
  DebugIntegrator(const Scene& scene, const IntegratorOptions& options);
  static Result<std::unique_ptr<Integrator>> Create(const Scene& scene,
                                                    const IntegratorOptions& options);

  std::unique_ptr<Workspace> MakeWorkspace() const override;
  void Trace(std::span<const SampleRequest> samples, Workspace* workspace,
             const SampleOutput& output) const override;

 private:
  struct Batch;

  void ShowSurfaces(std::span<const SampleRequest> samples, Batch* batch,
                    const SampleOutput& output) const;
  void ShowEffort(std::span<const SampleRequest> samples, Batch* batch,
                  const SampleOutput& output) const;
  Rgb ColorOf(const Ray& ray, const HitRecord& hit) const;

  const Scene& scene_;
  DebugView view_;
  ShutterTimes times_;
  float middle_depth_ = 1;  ///< What is so far away is half as bright as it can be.
  /// What does the work of which the effort is shown; null for views of surfaces.
  std::unique_ptr<const Integrator> worker_;
};

}  // namespace candela
