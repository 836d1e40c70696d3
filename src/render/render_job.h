#pragma once

#include <atomic>
#include <cstdint>

#include "base/cancel_token.h"
#include "base/result.h"
#include "film/encode_film.h"
#include "film/film.h"
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

  /// How far it is; may be asked from another thread while `Run` works.
  uint64_t SamplesDone() const { return samples_done_.load(std::memory_order_relaxed); }
  uint64_t SamplesTotal() const;
  uint64_t RaysTraced() const { return rays_traced_.load(std::memory_order_relaxed); }

  /// All rays by kind, once `Run` has returned.
  const RayCounts& Rays() const { return rays_; }

 private:
  class Worker;

  const Integrator& integrator_;
  const RenderOptions& options_;
  Film film_;
  RayCounts rays_;
  std::atomic<uint64_t> samples_done_ = 0;
  std::atomic<uint64_t> rays_traced_ = 0;
};

/// Memory in bytes that a picture of this size takes from the first ray to the written file, apart
/// from the scene; the largest number when it exceeds that.
uint64_t EstimateMemory(const RenderOptions& options, bool with_first_hits);

}  // namespace candela
