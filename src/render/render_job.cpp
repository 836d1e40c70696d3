#include "render/render_job.h"

#include <algorithm>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include "base/parallel.h"
#include "render/pixel_order.h"
#include "render/row_feed.h"
#include "render/sample_placer.h"
#include "render/splat_placer.h"
#include "render/tiles.h"

namespace candela {
namespace {

// Of a job that keeps sums: what is lost when it is stopped, and how often all threads wait for the
// last one.
constexpr uint32_t kSamplesOfPass = 16;

}  // namespace

/// What one thread needs: the tile in work and the samples that go to the integrator together.
class RenderJob::Worker {
 public:
  Worker(RenderJob* job, const SamplePlacer& placer, const CancelToken& cancel)
      : job_(*job),
        placer_(placer),
        cancel_(cancel),
        clamp_(job->options_.clamp),
        has_layers_(!job->options_.layers.IsEmpty()),
        has_one_sample_(job->options_.samples == 1 && !has_layers_ && !job->film_.KeepsSums() &&
                        job->options_.pattern == SamplePattern::kCentre),
        workspace_(job->integrator_.MakeWorkspace()) {}

  /// Renders the samples from `begin` to before `end` of a tile. False when it is left because
  /// `cancel` is set; then it does not come into the film.
  bool RenderTile(const PixelWindow& window, uint32_t begin, uint32_t end) {
    dropped_of_tile_ = {};
    lost_of_tile_ = {};
    if (!has_one_sample_) job_.film_.BeginTile(window, &tile_);
    bool is_cancelled = false;
    ForEachPixel(window, [&](int x, int y) {
      for (uint32_t index = begin; index < end; ++index) {
        const SamplePlacer::Placed placed = placer_.Place(x, y, index);
        requests_.push_back(placed.request);
        weights_.push_back(placed.weight);
        if (has_layers_) {
          const bool is_nearest = tile_.LayersAt(x, y).IsNearest(placed.off_centre, index);
          wants_surface_.push_back(is_nearest ? 1 : 0);
        }
        if (requests_.size() < kBatch) continue;
        // Asked here, since a tile of many samples per pixel takes minutes.
        is_cancelled = cancel_.IsCancelled();
        if (is_cancelled) return false;
        TraceBatch();
      }
      return true;
    });
    if (is_cancelled) {
      requests_.clear();
      weights_.clear();
      wants_surface_.clear();
      return false;
    }
    TraceBatch();
    if (!has_one_sample_) job_.film_.EndTile(tile_);
    if (job_.splats_) AddSplats(window);
    dropped_ += dropped_of_tile_;
    lost_ += lost_of_tile_;
    return true;
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
  /// What was left out since the last call.
  DroppedSamples TakeDropped() { return std::exchange(dropped_, {}); }
  ClampLoss TakeLost() { return std::exchange(lost_, {}); }

 private:
  static constexpr size_t kBatch = 1024;

  void TraceBatch() {
    const uint64_t rays_before = workspace_->rays.Total();
    radiance_.resize(requests_.size());
    if (has_layers_) layers_.resize(requests_.size());
    job_.integrator_.Trace(
        requests_, workspace_.get(),
        {radiance_, layers_, job_.options_.layers.Has(Layer::kUv), wants_surface_});
    for (size_t i = 0; i < requests_.size(); ++i) TakeSample(i);
    wants_surface_.clear();
    CountDone(requests_.size(), rays_before);
    requests_.clear();
    weights_.clear();
  }

  void TakeSample(size_t i) {
    const int x = static_cast<int>(requests_[i].x), y = static_cast<int>(requests_[i].y);
    // Of those nearer than all before them the last one is the nearest.
    if (has_layers_ && wants_surface_[i]) tile_.LayersAt(x, y).SetSurface(layers_[i].surface);
    const Rgb radiance = radiance_[i].ToRgb();
    const float factor = clamp_.IsOn() ? clamp_.Factor(radiance) : 1;
    const Rgb limited = radiance * factor;
    const bool is_taken = has_one_sample_ ? job_.film_.SetOnlySample(x, y, limited)
                                          : tile_.Add(x, y, limited, weights_[i]);
    if (!is_taken) {
      dropped_of_tile_.Add({x, y, requests_[i].index, radiance});
      return;
    }
    if (clamp_.IsOn()) SampleClamp::Count(radiance, factor, weights_[i], &lost_of_tile_);
    if (!has_layers_) return;
    if (factor < 1) {
      for (Rgb& light : layers_[i].light) light *= factor;
    }
    tile_.AddLayers(x, y, layers_[i], limited, weights_[i]);
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
  const SampleClamp clamp_;
  const bool has_layers_;
  /// Pixels with one sample in their middle need no sums. The course's pictures are such.
  const bool has_one_sample_;
  std::unique_ptr<Workspace> workspace_;
  FilmTile tile_;
  std::vector<SampleRequest> requests_;
  std::vector<float> weights_;
  std::vector<Spectrum> radiance_;
  std::vector<SampleLayers> layers_;    ///< Empty when nobody asks for layers.
  std::vector<uint8_t> wants_surface_;  ///< The same; the nearest to the middle of their pixels.
  std::vector<Splat> splats_;
  DroppedSamples dropped_, dropped_of_tile_;
  ClampLoss lost_, lost_of_tile_;
};

RenderJob::RenderJob(const Integrator& integrator, const RenderOptions& options, Film::Keep keep)
    : integrator_(integrator),
      options_(options),
      film_(options.crop, keep,
            options.drops_negative ? Film::Negative::kDrop : Film::Negative::kTake, options.layers),
      tile_samples_(static_cast<size_t>(Tiles(options.crop, options.tile_size).Count())) {
  if (!integrator.TracesLightPaths()) return;
  CHECK(keep == Film::Keep::kColours);  // The sums of a film hold nothing of what paths bring.
  splats_.emplace(options.crop);
}

uint64_t RenderJob::LightPaths() const {
  if (!splats_) return 0;
  return PixelWindow{0, 0, options_.width, options_.height}.PixelCount() * options_.samples;
}

uint64_t RenderJob::SamplesTotal() const {
  return options_.crop.PixelCount() * options_.samples + LightPaths();
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

bool RenderJob::CanRestore(const RenderState& state) const {
  return state.tile_samples.size() == tile_samples_.size() &&
         state.sums.size() == options_.crop.PixelCount();
}

void RenderJob::Restore(const RenderState& state) {
  CHECK(CanRestore(state));
  tile_samples_ = state.tile_samples;
  film_.Restore(state.sums);
  dropped_ = state.dropped;
  lost_ = state.lost;
  samples_done_ = SamplesInFilm();
}

uint64_t RenderJob::SamplesInFilm() const {
  const Tiles tiles(options_.crop, options_.tile_size);
  uint64_t sum = 0;
  for (int64_t i = 0; i < tiles.Count(); ++i) {
    sum += tiles.Window(i).PixelCount() * tile_samples_[static_cast<size_t>(i)];
  }
  return sum;
}

Result<void> RenderJob::Run(const CancelToken& cancel, FilmEncoder* encoder,
                            const std::function<Result<void>()>& after_pass) {
  const SamplePlacer placer(options_);
  const Tiles tiles(options_.crop, options_.tile_size);
  Workers workers(static_cast<size_t>(ThreadCount()));
  for (auto& worker : workers) worker = std::make_unique<Worker>(this, placer, cancel);
  // All of them come first: a pixel is done when its tile is.
  TraceLightPaths(workers, cancel);
  const uint32_t step = film_.KeepsSums() ? kSamplesOfPass : options_.samples;
  // Passes that all tiles have been through are not made again.
  const uint32_t least = *std::min_element(tile_samples_.begin(), tile_samples_.end());
  uint32_t end = std::min(least, options_.samples - 1) / step * step;
  while (end < options_.samples) {
    end += std::min(step, options_.samples - end);
    const bool is_last = end == options_.samples;
    RowFeed feed(tiles, is_last ? encoder : nullptr);
    ParallelForWorkers(tiles.Count(), [&](int64_t tile, int worker) {
      uint32_t& done = tile_samples_[static_cast<size_t>(tile)];
      if (cancel.IsCancelled()) return;
      if (done < end) {
        const bool is_rendered =
            workers[static_cast<size_t>(worker)]->RenderTile(tiles.Window(tile), done, end);
        if (!is_rendered) return;
        done = end;
      }
      feed.TileDone(tile);
    });
    for (const auto& worker : workers) {
      dropped_ += worker->TakeDropped();
      lost_ += worker->TakeLost();
    }
    if (cancel.IsCancelled()) break;
    if (is_last || !after_pass) continue;
    if (auto went_on = after_pass(); !went_on) return went_on;
  }
  for (const auto& worker : workers) rays_ += worker->Rays();
  if (cancel.IsCancelled()) return Error{ErrorCode::kStopped, "stopped on request"};
  return {};
}

uint64_t EstimateMemory(const RenderOptions& options, const Integrator& integrator,
                        bool with_first_hits, bool with_sums) {
  // Per pixel: the film's and the encoder's floats, the quantised samples, the encoded file in the
  // worst case, and some room for what the libraries add.
  uint64_t per_pixel = 12 + 12 + 6 + 8 + 8 + (with_first_hits ? 20 : 0);
  if (integrator.TracesLightPaths()) per_pixel += 48;  // See `SplatFilm`.
  if (with_sums) per_pixel += 3 * sizeof(PixelSums);   // And the file, and what is read from it.
  for (size_t i = 0; i < kLayerCount; ++i) {
    // The words of the film, and those of the file.
    const uint64_t channels = Layers()[i].channels.size();
    if (options.layers.Has(static_cast<Layer>(i))) per_pixel += 8 * channels;
  }
  const uint64_t pixels = options.crop.PixelCount();
  const uint64_t most = std::numeric_limits<uint64_t>::max();
  return pixels > most / per_pixel ? most : pixels * per_pixel;
}

}  // namespace candela
