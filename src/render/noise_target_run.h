#pragma once

#include <atomic>
#include <cstdint>
#include <functional>

#include "base/cancel_token.h"
#include "film/film.h"
#include "render/noise_block.h"
#include "render/render_options.h"
#include "render/sample_tracer.h"
#include "render/tiles.h"
#include "render/time_limit.h"

namespace candela {

/// Renders a film block by block until there is little enough noise.
class NoiseTargetRun {
 public:
  /// Gives the tracer of a worker.
  using TracerOf = std::function<SampleTracer*(int worker)>;

  /// All have to outlive it. The film may show a part of the picture; what else the blocks at its
  /// edges hold is rendered as well, so that they come out as in the whole picture.
  NoiseTargetRun(const RenderOptions& options, const TimeLimit& limit, Film* film);

  /// To the end, or until `cancel` is set. Without a limit of time each block is done before the
  /// next one begins; with one, all of them advance together.
  void Run(const CancelToken& cancel, const TracerOf& tracer_of);

  /// In [0, 1], also while it runs.
  double Progress() const;
  /// Samples of pixels of the film that are in it,
  uint64_t SamplesInFilm() const { return samples_; }
  /// and how many of the film's pixels are in blocks that would need more.
  uint64_t NoisyPixels() const { return noisy_pixels_; }

  /// Memory in bytes per pixel that has to be there at the same time.
  static uint64_t BytesPerPixel(const RenderOptions& options);

 private:
  void RunOneByOne(const CancelToken& cancel, const TracerOf& tracer_of);
  void RunTogether(const CancelToken& cancel, const TracerOf& tracer_of);
  void Count(const NoiseBlock& block);

  const RenderOptions& options_;
  const TimeLimit& limit_;
  Film& film_;
  const Tiles blocks_;
  std::atomic<int64_t> blocks_done_ = 0;
  std::atomic<uint64_t> samples_ = 0, noisy_pixels_ = 0;
};

}  // namespace candela
