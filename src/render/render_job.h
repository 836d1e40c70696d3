#pragma once

#include <atomic>
#include <cstdint>
#include <vector>

#include "base/cancel_token.h"
#include "base/result.h"
#include "image/raster.h"
#include "integrators/first_hit.h"
#include "integrators/integrator.h"
#include "render/render_options.h"
#include "scene/scene.h"

namespace candela {

/// A rendered picture: linear red, green and blue, unclamped, of the crop window.
struct RenderResult {
  Image image;
  RayCounts rays;
  uint64_t dropped_samples = 0;  ///< NaN, infinite or negative ones.
};

/// Renders one picture on all threads (see `ThreadLimit`). The result depends on the scene, the
/// integrator and the options alone.
class RenderJob {
 public:
  /// All three have to outlive the job.
  RenderJob(const Scene& scene, const Integrator& integrator, const RenderOptions& options);

  /// Runs to the end, or until `cancel` is set: then the error is `kStopped`.
  Result<RenderResult> Run(const CancelToken& cancel);

  /// How far it is; may be asked from another thread while `Run` works.
  uint64_t SamplesDone() const { return samples_done_.load(std::memory_order_relaxed); }
  uint64_t SamplesTotal() const;
  uint64_t RaysTraced() const { return rays_traced_.load(std::memory_order_relaxed); }

 private:
  const Scene& scene_;
  const Integrator& integrator_;
  const RenderOptions& options_;
  std::atomic<uint64_t> samples_done_ = 0;
  std::atomic<uint64_t> rays_traced_ = 0;
};

/// What the camera ray through the middle of each pixel of the crop window finds first, row by row.
std::vector<FirstHit> RenderFirstHits(const Scene& scene, const RenderOptions& options);

/// The sample of a pixel that stands for it when one ray is explained: the one in its middle.
SampleRequest CentreSample(const RenderOptions& options, uint32_t x, uint32_t y);

/// Memory in bytes that rendering and writing a picture of this size takes, apart from the scene;
/// the largest number when it exceeds that.
uint64_t EstimateMemory(const RenderOptions& options, bool with_first_hits);

}  // namespace candela
