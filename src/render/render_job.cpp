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
        has_one_sample_(job->options_.samples == 1 && job->options_.layers.IsEmpty() &&
                        !job->film_.KeepsSums() && job->options_.pattern == SamplePattern::kCentre),
        tracer_(job->integrator_, job->options_, placer, cancel, &job->counters_) {}

  /// Renders the samples from `begin` to before `end` of a tile. False when it is left because that
  /// was asked for; then it does not come into the film.
  bool RenderTile(const PixelWindow& window, uint32_t begin, uint32_t end) {
    if (has_one_sample_) {
      if (!tracer_.TraceOnlySample(window, &job_.film_)) return false;
    } else {
      job_.film_.BeginTile(window, &tile_);
      if (!tracer_.Trace({begin, end}, &tile_)) return false;
      job_.film_.EndTile(tile_);
    }
    if (job_.splats_) AddSplats(window);
    return true;
  }

  /// Those numbered from `first` on.
  void TraceLightPaths(uint64_t first, uint64_t count, const SplatPlacer& placer) {
    const uint64_t rays_before = tracer_.Rays().Total();
    splats_.clear();
    job_.integrator_.TraceLightPaths(first, count, tracer_.GetWorkspace(), &splats_);
    for (const Splat& splat : splats_) placer.Add(splat, &*job_.splats_);
    job_.counters_.Add(count, tracer_.Rays().Total() - rays_before);
  }

  SampleTracer& Tracer() { return tracer_; }

 private:
  void AddSplats(const PixelWindow& window) {
    const uint64_t paths = job_.LightPaths();
    ForEachPixel(window, [&](int x, int y) {
      job_.film_.AddToColour(x, y, job_.splats_->Mean(x, y, paths));
      return true;
    });
  }

  RenderJob& job_;
  /// Pixels with one sample in their middle need no sums.
  const bool has_one_sample_;
  SampleTracer tracer_;
  FilmTile tile_;
  std::vector<Splat> splats_;
};

RenderJob::RenderJob(const Integrator& integrator, const RenderOptions& options, Film::Keep keep)
    : integrator_(integrator),
      options_(options),
      film_(options.crop, keep,
            options.drops_negative ? Film::Negative::kDrop : Film::Negative::kTake, options.layers,
            options.light_groups),
      tile_samples_(static_cast<size_t>(Tiles(options.crop, options.tile_size).Count())),
      limit_(options.time_limit) {
  if (options.noise_target) noise_run_.emplace(options, limit_, &film_);
  CHECK(!options.time_limit || noise_run_ || keep == Film::Keep::kSums);
  CHECK(!noise_run_ || keep == Film::Keep::kColours);
  if (!integrator.TracesLightPaths()) return;
  // The sums of a film hold nothing of what paths bring.
  CHECK(keep == Film::Keep::kColours && !noise_run_);
  splats_.emplace(options.crop);
}

uint64_t RenderJob::LightPaths() const {
  if (!splats_) return 0;
  return PixelWindow{0, 0, options_.width, options_.height}.PixelCount() * options_.samples;
}

uint64_t RenderJob::SamplesTotal() const {
  return options_.crop.PixelCount() * options_.samples + LightPaths();
}

double RenderJob::Progress() const {
  if (noise_run_) return noise_run_->Progress();
  const double of_samples =
      static_cast<double>(SamplesDone()) / static_cast<double>(SamplesTotal());
  return std::max(of_samples, limit_.Progress());
}

double RenderJob::NoisyPart() const {
  if (!noise_run_) return 0;
  return static_cast<double>(noise_run_->NoisyPixels()) /
         static_cast<double>(options_.crop.PixelCount());
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
  counters_.samples = SamplesInFilm();
}

uint64_t RenderJob::SamplesInFilm() const {
  if (noise_run_) return noise_run_->SamplesInFilm();
  const Tiles tiles(options_.crop, options_.tile_size);
  uint64_t sum = 0;
  for (int64_t i = 0; i < tiles.Count(); ++i) {
    sum += tiles.Window(i).PixelCount() * tile_samples_[static_cast<size_t>(i)];
  }
  return sum;
}

/// Where a pass ends that begins when all pixels have `done` samples.
uint32_t RenderJob::PassEnd(uint32_t done) const {
  if (!film_.KeepsSums()) return options_.samples;
  // With a limit of time the first ones are short, to have something to end with.
  const bool is_short = options_.time_limit && done < kSamplesOfPass;
  const uint32_t end =
      is_short ? std::max(2 * done, uint32_t{1}) : (done / kSamplesOfPass + 1) * kSamplesOfPass;
  return std::min(end, options_.samples);
}

void RenderJob::TakeLosses(const Workers& workers) {
  for (const auto& worker : workers) {
    dropped_ += worker->Tracer().TakeDropped();
    lost_ += worker->Tracer().TakeLost();
  }
}

Result<void> RenderJob::Run(const CancelToken& cancel, FilmEncoder* encoder,
                            const std::function<Result<void>()>& after_pass) {
  const SamplePlacer placer(options_);
  Workers workers(static_cast<size_t>(ThreadCount()));
  for (auto& worker : workers) worker = std::make_unique<Worker>(this, placer, cancel);
  limit_.Start();
  Result<void> done;
  if (noise_run_) {
    noise_run_->Run(cancel,
                    [&](int worker) { return &workers[static_cast<size_t>(worker)]->Tracer(); });
    TakeLosses(workers);
  } else {
    // All of them come first: a pixel is done when its tile is.
    TraceLightPaths(workers, cancel);
    done = RunPasses(workers, cancel, encoder, after_pass);
  }
  for (const auto& worker : workers) rays_ += worker->Tracer().Rays();
  if (cancel.IsCancelled()) return Error{ErrorCode::kStopped, "stopped on request"};
  return done;
}

Result<void> RenderJob::RunPasses(const Workers& workers, const CancelToken& cancel,
                                  FilmEncoder* encoder,
                                  const std::function<Result<void>()>& after_pass) {
  const Tiles tiles(options_.crop, options_.tile_size);
  // Passes that all tiles have been through are not made again, but for one that feeds the encoder.
  uint32_t end = *std::min_element(tile_samples_.begin(), tile_samples_.end());
  bool is_last = false;
  while (!is_last) {
    end = PassEnd(end);
    is_last = end == options_.samples;
    RowFeed feed(tiles, is_last ? encoder : nullptr);
    ParallelForWorkers(tiles.Count(), [&](int64_t tile, int worker) {
      uint32_t& done = tile_samples_[static_cast<size_t>(tile)];
      if (cancel.IsCancelled()) return;
      if (done < end) {
        if (done > 0 && limit_.IsOver()) return;
        const bool is_rendered =
            workers[static_cast<size_t>(worker)]->RenderTile(tiles.Window(tile), done, end);
        if (!is_rendered) return;
        done = end;
      }
      feed.TileDone(tile);
    });
    TakeLosses(workers);
    if (cancel.IsCancelled() || limit_.IsOver()) break;
    if (is_last || !after_pass) continue;
    if (auto went_on = after_pass(); !went_on) return went_on;
  }
  return {};
}

uint64_t EstimateMemory(const RenderOptions& options, const Integrator& integrator,
                        bool with_first_hits, bool with_sums) {
  // Per pixel: the film's and the encoder's floats, the quantised samples, the encoded file in the
  // worst case, and some room for what the libraries add.
  uint64_t per_pixel = 12 + 12 + 6 + 8 + 8 + (with_first_hits ? 20 : 0);
  if (integrator.TracesLightPaths()) per_pixel += 48;  // See `SplatFilm`.
  if (with_sums) per_pixel += 3 * sizeof(PixelSums);   // And the file, and what is read from it.
  if (options.noise_target) {
    per_pixel += NoiseTargetRun::BytesPerPixel(options);
  } else if (options.time_limit) {
    per_pixel += FilmTile::BytesOfSeries(!options.layers.IsEmpty(), options.light_groups.size());
  }
  for (size_t i = 0; i < kLayerCount; ++i) {
    // The words of the film, and those of the file.
    const LayerEntry& layer = Layers()[i];
    const uint64_t layers = layer.is_of_groups ? options.light_groups.size() : 1;
    if (options.layers.Has(static_cast<Layer>(i))) per_pixel += 8 * layers * layer.channels.size();
  }
  const uint64_t pixels = options.crop.PixelCount();
  const uint64_t most = std::numeric_limits<uint64_t>::max();
  return pixels > most / per_pixel ? most : pixels * per_pixel;
}

}  // namespace candela
