#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <vector>

#include "base/cancel_token.h"
#include "film/film.h"
#include "film/pixel_filter.h"
#include "integrators/integrator.h"
#include "render/dropped_samples.h"
#include "render/render_options.h"
#include "render/sample_clamp.h"
#include "render/sample_placer.h"

namespace candela {

/// How far the threads of a job are together; may be read while they work.
struct RenderCounters {
  std::atomic<uint64_t> samples = 0, rays = 0;

  void Add(uint64_t more_samples, uint64_t more_rays) {
    samples.fetch_add(more_samples, std::memory_order_relaxed);
    rays.fetch_add(more_rays, std::memory_order_relaxed);
  }
};

/// The samples of every pixel from `begin` to before `end`.
struct SampleRange {
  uint32_t begin = 0, end = 0;
  /// Samples of one series know nothing of those of the other; 0 or 1.
  uint32_t series = 0;
};

/// Carries samples from the pixel to the integrator and back, many together. For one thread.
class SampleTracer {
 public:
  /// All have to outlive it.
  SampleTracer(const Integrator& integrator, const RenderOptions& options,
               const SamplePlacer& placer, const CancelToken& cancel, RenderCounters* counters);

  /// Traces samples of the tile's pixels and adds them to the tile. False when it stopped because
  /// that was asked for, and the tile is of no use.
  bool Trace(SampleRange range, FilmTile* tile);

  /// The same for pictures with one sample in the middle of each pixel, which need no sums. The
  /// course's pictures are such.
  bool TraceOnlySample(const PixelWindow& window, Film* film);

  RayCounts& Rays() { return workspace_->rays; }
  Workspace* GetWorkspace() { return workspace_.get(); }
  /// What was left out of whatever was traced to the end, since the last call.
  DroppedSamples TakeDropped();
  ClampLoss TakeLost();

 private:
  template <class Take>
  bool TraceWindow(const PixelWindow& window, SampleRange range, FilmTile* tile, Take take);
  template <class Take>
  void TraceBatch(FilmTile* tile, Take take);
  /// Which samples are to tell of their surface.
  void FindNearest(FilmTile* tile);
  template <class Take>
  void TakeSample(size_t i, FilmTile* tile, Take take);

  const Integrator& integrator_;
  const RenderOptions& options_;
  const SamplePlacer& placer_;
  const CancelToken& cancel_;
  RenderCounters& counters_;
  const SampleClamp clamp_;
  const bool has_layers_;
  const size_t group_count_;  ///< Of groups of lights that have layers.
  std::unique_ptr<Workspace> workspace_;
  std::vector<SampleRequest> requests_;
  std::vector<FilterSample> places_;
  std::vector<Spectrum> radiance_;
  std::vector<SampleLayers> layers_;    ///< Empty when nobody asks for layers.
  std::vector<Rgb> group_light_;        ///< See `SampleOutput`.
  std::vector<uint8_t> wants_surface_;  ///< The same; the nearest to the middle of their pixels.
  DroppedSamples dropped_, dropped_of_window_;
  ClampLoss lost_, lost_of_window_;
};

}  // namespace candela
