#include "render/noise_target_run.h"

#include <algorithm>
#include <vector>

#include "base/parallel.h"

namespace candela {
namespace {

/// The window with all of its blocks, as far as the picture goes.
PixelWindow WholeBlocks(const RenderOptions& options) {
  const auto up = [](int x) { return (x + NoiseBlock::kSide - 1) / NoiseBlock::kSide; };
  const PixelWindow& crop = options.crop;
  const int side = NoiseBlock::kSide;
  return {crop.x0 / side * side, crop.y0 / side * side, std::min(up(crop.x1) * side, options.width),
          std::min(up(crop.y1) * side, options.height)};
}

}  // namespace

NoiseTargetRun::NoiseTargetRun(const RenderOptions& options, const TimeLimit& limit, Film* film)
    : options_(options),
      limit_(limit),
      film_(*film),
      blocks_(WholeBlocks(options), NoiseBlock::kSide) {}

void NoiseTargetRun::Run(const CancelToken& cancel, const TracerOf& tracer_of) {
  options_.time_limit ? RunTogether(cancel, tracer_of) : RunOneByOne(cancel, tracer_of);
}

void NoiseTargetRun::RunOneByOne(const CancelToken& cancel, const TracerOf& tracer_of) {
  ParallelForWorkers(blocks_.Count(), [&](int64_t i, int worker) {
    NoiseBlock block(blocks_.Window(i), options_, film_);
    while (!block.IsDone()) {
      if (cancel.IsCancelled() || !block.Advance(tracer_of(worker))) return;
    }
    block.Show(&film_);
    Count(block);
    ++blocks_done_;
  });
}

void NoiseTargetRun::RunTogether(const CancelToken& cancel, const TracerOf& tracer_of) {
  std::vector<NoiseBlock> blocks;
  for (int64_t i = 0; i < blocks_.Count(); ++i) {
    blocks.emplace_back(blocks_.Window(i), options_, film_);
  }
  // All get their first samples, however long that takes.
  for (bool is_first = true; blocks_done_ < blocks_.Count(); is_first = false) {
    ParallelForWorkers(blocks_.Count(), [&](int64_t i, int worker) {
      NoiseBlock& block = blocks[static_cast<size_t>(i)];
      if (block.IsDone() || cancel.IsCancelled()) return;
      if (!is_first && limit_.IsOver()) return;
      if (!block.Advance(tracer_of(worker))) return;
      block.Show(&film_);
      if (block.IsDone()) ++blocks_done_;
    });
    if (cancel.IsCancelled()) return;
    if (limit_.IsOver()) break;
  }
  for (const NoiseBlock& block : blocks) Count(block);
}

void NoiseTargetRun::Count(const NoiseBlock& block) {
  const uint64_t pixels = block.Window().Intersection(film_.Window()).PixelCount();
  samples_ += pixels * block.SamplesInPicture();
  if (!block.IsDone() || block.HasMissedTarget()) noisy_pixels_ += pixels;
}

double NoiseTargetRun::Progress() const {
  const double of_blocks =
      static_cast<double>(blocks_done_.load()) / static_cast<double>(blocks_.Count());
  return std::max(of_blocks, limit_.Progress());
}

uint64_t NoiseTargetRun::BytesPerPixel(const RenderOptions& options) {
  if (!options.time_limit) return 0;
  // Two that run, and what was kept of one of them.
  return 3 * FilmTile::BytesOfSeries(!options.layers.IsEmpty(), options.light_groups.size());
}

}  // namespace candela
