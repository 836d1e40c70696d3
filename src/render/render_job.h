#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "base/cancel_token.h"
#include "base/result.h"
#include "film/encode_film.h"
#include "film/film.h"
#include "film/splat_film.h"
#include "integrators/integrator.h"
#include "render/dropped_samples.h"
#include "render/noise_target_run.h"
#include "render/render_options.h"
#include "render/sample_clamp.h"
#include "render/sample_tracer.h"
#include "render/time_limit.h"

namespace candela {

/// What a job that keeps sums has done so far.
struct RenderState {
  std::vector<uint32_t> tile_samples;  ///< Samples of each pixel, tile by tile.
  std::vector<PixelSums> sums;         ///< Of all pixels, row after row.
  DroppedSamples dropped;
  ClampLoss lost;
};

/// Renders one picture on all threads (see `ThreadLimit`). The result depends on the scene, the
/// integrator and the options alone.
class RenderJob {
 public:
  /// Both have to outlive the job. One that keeps sums renders the picture in passes of a few
  /// samples each, can be asked what it has done so far, and without layers can go on from there
  /// another time. That is not for integrators that trace light paths, and not for a noise target;
  /// a time limit needs one of the two.
  RenderJob(const Integrator& integrator, const RenderOptions& options,
            Film::Keep keep = Film::Keep::kColours);

  /// Runs to the end, or until `cancel` is set: then the error is `kStopped`. Once per job. An
  /// `encoder` of the job's film, if there is one, gets rows as soon as they are done.
  /// `after_pass`, if there is one, is called after each pass but the last of a job that keeps
  /// sums; its error ends the work.
  Result<void> Run(const CancelToken& cancel, FilmEncoder* encoder = nullptr,
                   const std::function<Result<void>()>& after_pass = {});

  /// Goes on from a state that fits a job that keeps sums, before `Run`.
  bool CanRestore(const RenderState& state) const;
  void Restore(const RenderState& state);
  const std::vector<uint32_t>& TileSamples() const { return tile_samples_; }
  uint32_t SamplesOfPixel() const { return options_.samples; }
  /// All samples of tiles that are in the film, while `Run` does not work.
  uint64_t SamplesInFilm() const;

  /// The picture: linear red, green and blue, unclamped, of the crop window.
  const Film& film() const { return film_; }

  // How far it is; may be asked from another thread while `Run` works. Light paths count as
  // samples.
  uint64_t SamplesDone() const { return counters_.samples.load(std::memory_order_relaxed); }
  /// The most that there can be.
  uint64_t SamplesTotal() const;
  uint64_t RaysTraced() const { return counters_.rays.load(std::memory_order_relaxed); }
  /// In [0, 1]: about which part of the way is done.
  double Progress() const;

  /// All rays by kind, once `Run` has returned.
  const RayCounts& Rays() const { return rays_; }
  /// And then, or after a pass, what did not come into the picture.
  const DroppedSamples& Dropped() const { return dropped_; }
  const ClampLoss& Lost() const { return lost_; }
  /// How many splats of light paths were left out because such light is not possible.
  uint64_t DroppedSplats() const { return splats_ ? splats_->DroppedSplats() : 0; }
  /// What part of the pixels is in blocks that are still noisier than the noise target.
  double NoisyPart() const;

 private:
  class Worker;
  using Workers = std::vector<std::unique_ptr<Worker>>;

  /// How many light paths there are: one for each sample of each pixel of the whole picture, so
  /// that a crop gets the light that it has there.
  uint64_t LightPaths() const;
  void TraceLightPaths(const Workers& workers, const CancelToken& cancel);
  uint32_t PassEnd(uint32_t done) const;
  Result<void> RunPasses(const Workers& workers, const CancelToken& cancel, FilmEncoder* encoder,
                         const std::function<Result<void>()>& after_pass);
  void TakeLosses(const Workers& workers);

  const Integrator& integrator_;
  const RenderOptions& options_;
  Film film_;
  std::vector<uint32_t> tile_samples_;
  std::optional<SplatFilm> splats_;  ///< For integrators that trace light paths.
  RayCounts rays_;
  DroppedSamples dropped_;
  ClampLoss lost_;
  RenderCounters counters_;
  TimeLimit limit_;
  std::optional<NoiseTargetRun> noise_run_;
};

/// Memory in bytes that a picture of this size takes from the first ray to the written file, apart
/// from the scene; the largest number when it exceeds that. With first hits for maps, and with sums
/// for a checkpoint.
uint64_t EstimateMemory(const RenderOptions& options, const Integrator& integrator,
                        bool with_first_hits, bool with_sums);

}  // namespace candela
