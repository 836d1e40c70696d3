#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "base/cancel_token.h"
#include "base/result.h"
#include "film/encode_film.h"
#include "film/film.h"
#include "film/splat_film.h"
#include "integrators/integrator.h"
#include "render/render_options.h"

namespace candela {

/// Renders one picture on all threads (see `ThreadLimit`). The result depends on the scene, the
/// integrator and the options alone.
class RenderJob {
 public:
  /// Both have to outlive the job.
  RenderJob(const Integrator& integrator, const RenderOptions& options);

  /// Runs to the end, or until `cancel` is set: then the error is `kStopped`. Once per job. An
  /// `encoder` of the job's film, if there is one, gets rows as soon as they are done.
  Result<void> Run(const CancelToken& cancel, FilmEncoder* encoder = nullptr);

  /// The picture: linear red, green and blue, unclamped, of the crop window.
  const Film& film() const { return film_; }

  /// How many samples and splats were left out because they were not finite, once `Run` has
  /// returned.
  uint64_t DroppedSamples() const;

  /// How far it is; may be asked from another thread while `Run` works. Light paths count as
  /// samples.
  uint64_t SamplesDone() const { return samples_done_.load(std::memory_order_relaxed); }
  uint64_t SamplesTotal() const;
  uint64_t RaysTraced() const { return rays_traced_.load(std::memory_order_relaxed); }

  /// All rays by kind, once `Run` has returned.
  const RayCounts& Rays() const { return rays_; }

 private:
  class Worker;
  using Workers = std::vector<std::unique_ptr<Worker>>;

  /// How many light paths there are: one for each sample of each pixel of the whole picture, so
  /// that a crop gets the light that it has there.
  uint64_t LightPaths() const;
  void TraceLightPaths(const Workers& workers, const CancelToken& cancel);

  const Integrator& integrator_;
  const RenderOptions& options_;
  Film film_;
  std::optional<SplatFilm> splats_;  ///< For integrators that trace light paths.
  RayCounts rays_;
  std::atomic<uint64_t> samples_done_ = 0;
  std::atomic<uint64_t> rays_traced_ = 0;
};

/// Memory in bytes that a picture of this size takes from the first ray to the written file, apart
/// from the scene; the largest number when it exceeds that.
uint64_t EstimateMemory(const RenderOptions& options, const Integrator& integrator,
                        bool with_first_hits);

}  // namespace candela
