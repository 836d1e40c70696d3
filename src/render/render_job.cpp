#include "render/render_job.h"

#include <algorithm>
#include <limits>

#include "base/parallel.h"
#include "render/pixel_order.h"
#include "render/row_feed.h"
#include "render/sample_placer.h"
#include "render/splat_placer.h"
#include "render/tiles.h"

namespace candela {

/// What one thread needs: the tile in work and the samples that go to the integrator together.
class RenderJob::Worker {
 public:
  Worker(RenderJob* job, const SamplePlacer& placer, const CancelToken& cancel)
      : job_(*job),
        placer_(placer),
        cancel_(cancel),
        has_one_sample_(job->options_.samples == 1 &&
                        job->options_.pattern == SamplePattern::kCentre),
        workspace_(job->integrator_.MakeWorkspace()) {}

  /// A tile that is left when `cancel` is set does not come into the film.
  void RenderTile(const PixelWindow& window) {
    if (!has_one_sample_) job_.film_.BeginTile(window, &tile_);
    bool is_cancelled = false;
    ForEachPixel(window, [&](int x, int y) {
      for (uint32_t index = 0; index < job_.options_.samples; ++index) {
        const SamplePlacer::Placed placed = placer_.Place(x, y, index);
        requests_.push_back(placed.request);
        weights_.push_back(placed.weight);
        if (requests_.size() < kBatch) continue;
        // Asked here, since a tile of many samples per pixel takes minutes.
        is_cancelled = cancel_.IsCancelled();
        if (is_cancelled) return false;
        TraceBatch();
      }
      return true;
    });
    if (is_cancelled) return;
    TraceBatch();
    if (!has_one_sample_) job_.film_.EndTile(tile_);
    if (job_.splats_) AddSplats(window);
  }

  /// Those numbered from `first` on.
  void TraceLightPaths(uint64_t first, uint64_t count, const SplatPlacer& placer) {
    const uint64_t rays_before = workspace_->rays.Total();
    splats_.clear();
    job_.integrator_.TraceLightPaths(first, count, workspace_.get(), &splats_);
    for (const Splat& splat : splats_) placer.Add(splat, &*job_.splats_);
    CountDone(count, rays_before);
  }

  const RayCounts& Rays() const { return workspace_->rays; }

 private:
  static constexpr size_t kBatch = 1024;

  void TraceBatch() {
    const uint64_t rays_before = workspace_->rays.Total();
    radiance_.resize(requests_.size());
    job_.integrator_.Trace(requests_, workspace_.get(), radiance_);
    for (size_t i = 0; i < requests_.size(); ++i) {
      const int x = static_cast<int>(requests_[i].x);
      const int y = static_cast<int>(requests_[i].y);
      if (has_one_sample_) {
        job_.film_.SetOnlySample(x, y, radiance_[i].ToRgb());
      } else {
        tile_.Add(x, y, radiance_[i].ToRgb(), weights_[i]);
      }
    }
    CountDone(requests_.size(), rays_before);
    requests_.clear();
    weights_.clear();
  }

  void AddSplats(const PixelWindow& window) {
    const uint64_t paths = job_.LightPaths();
    ForEachPixel(window, [&](int x, int y) {
      job_.film_.AddToColour(x, y, job_.splats_->Mean(x, y, paths));
      return true;
    });
  }

  void CountDone(uint64_t samples, uint64_t rays_before) {
    job_.samples_done_.fetch_add(samples, std::memory_order_relaxed);
    job_.rays_traced_.fetch_add(workspace_->rays.Total() - rays_before, std::memory_order_relaxed);
  }

  RenderJob& job_;
  const SamplePlacer& placer_;
  const CancelToken& cancel_;
  /// Pixels with one sample in their middle need no sums. The course's pictures are such.
  const bool has_one_sample_;
  std::unique_ptr<Workspace> workspace_;
  FilmTile tile_;
  std::vector<SampleRequest> requests_;
  std::vector<float> weights_;
  std::vector<Spectrum> radiance_;
  std::vector<Splat> splats_;
};

RenderJob::RenderJob(const Integrator& integrator, const RenderOptions& options)
    : integrator_(integrator), options_(options), film_(options.crop, Film::Keep::kColours) {
  if (integrator.TracesLightPaths()) splats_.emplace(options.crop);
}

uint64_t RenderJob::LightPaths() const {
  if (!splats_) return 0;
  return PixelCount({0, 0, options_.width, options_.height}) * options_.samples;
}

uint64_t RenderJob::SamplesTotal() const {
  return PixelCount(options_.crop) * options_.samples + LightPaths();
}

uint64_t RenderJob::DroppedSamples() const {
  return film_.DroppedSamples() + (splats_ ? splats_->DroppedSplats() : 0);
}

void RenderJob::TraceLightPaths(const Workers& workers, const CancelToken& cancel) {
  constexpr uint64_t kTogether = 4096;
  const SplatPlacer placer(options_);
  const uint64_t paths = LightPaths();
  const auto parts = static_cast<int64_t>((paths + kTogether - 1) / kTogether);
  ParallelForWorkers(parts, [&](int64_t part, int worker) {
    if (cancel.IsCancelled()) return;
    const uint64_t first = static_cast<uint64_t>(part) * kTogether;
    workers[static_cast<size_t>(worker)]->TraceLightPaths(first, std::min(kTogether, paths - first),
                                                          placer);
  });
}

Result<void> RenderJob::Run(const CancelToken& cancel, FilmEncoder* encoder) {
  const SamplePlacer placer(options_);
  const Tiles tiles(options_.crop, options_.tile_size);
  RowFeed feed(tiles, encoder);
  Workers workers(static_cast<size_t>(ThreadCount()));
  for (auto& worker : workers) worker = std::make_unique<Worker>(this, placer, cancel);
  // All of them come first: a pixel is done when its tile is.
  TraceLightPaths(workers, cancel);
  ParallelForWorkers(tiles.Count(), [&](int64_t tile, int worker) {
    if (cancel.IsCancelled()) return;
    workers[static_cast<size_t>(worker)]->RenderTile(tiles.Window(tile));
    if (!cancel.IsCancelled()) feed.TileDone(tile);
  });
  for (const auto& worker : workers) rays_ += worker->Rays();
  if (cancel.IsCancelled()) return Error{ErrorCode::kStopped, "stopped on request"};
  return {};
}

uint64_t EstimateMemory(const RenderOptions& options, const Integrator& integrator,
                        bool with_first_hits) {
  // Per pixel: the film's and the encoder's floats, the quantised samples, the encoded file in the
  // worst case, and some room for what the libraries add.
  const uint64_t per_pixel =
      12 + 12 + 6 + 8 + 8 + (with_first_hits ? 20 : 0) + (integrator.TracesLightPaths() ? 48 : 0);
  const uint64_t pixels = PixelCount(options.crop);
  const uint64_t most = std::numeric_limits<uint64_t>::max();
  return pixels > most / per_pixel ? most : pixels * per_pixel;
}

}  // namespace candela
