#include "render/sample_tracer.h"

#include <utility>

#include "render/pixel_order.h"

namespace candela {
namespace {

constexpr size_t kBatch = 1024;

}  // namespace

SampleTracer::SampleTracer(const Integrator& integrator, const RenderOptions& options,
                           const SamplePlacer& placer, const CancelToken& cancel,
                           RenderCounters* counters)
    : integrator_(integrator),
      options_(options),
      placer_(placer),
      cancel_(cancel),
      counters_(*counters),
      clamp_(options.clamp),
      has_layers_(!options.layers.IsEmpty()),
      group_count_(options.layers.Has(Layer::kLightGroups) ? options.light_groups.size() : 0),
      workspace_(integrator.MakeWorkspace()) {}

bool SampleTracer::Trace(SampleRange range, FilmTile* tile) {
  return TraceWindow(tile->Window(), range, tile, [tile](int x, int y, Rgb radiance, float weight) {
    return tile->Add(x, y, radiance, weight);
  });
}

bool SampleTracer::TraceOnlySample(const PixelWindow& window, Film* film) {
  return TraceWindow(window, {0, 1}, nullptr, [film](int x, int y, Rgb radiance, float /*weight*/) {
    return film->SetOnlySample(x, y, radiance);
  });
}

DroppedSamples SampleTracer::TakeDropped() {
  return std::exchange(dropped_, {});
}

ClampLoss SampleTracer::TakeLost() {
  return std::exchange(lost_, {});
}

template <class Take>
bool SampleTracer::TraceWindow(const PixelWindow& window, SampleRange range, FilmTile* tile,
                               Take take) {
  dropped_of_window_ = {};
  lost_of_window_ = {};
  bool is_cancelled = false;
  ForEachPixel(window, [&](int x, int y) {
    for (uint32_t index = range.begin; index < range.end; ++index) {
      requests_.push_back(SamplePlacer::Request(x, y, index, range.series));
      if (requests_.size() < kBatch) continue;
      // Asked here, since a tile of many samples per pixel takes minutes.
      is_cancelled = cancel_.IsCancelled();
      if (is_cancelled) return false;
      TraceBatch(tile, take);
    }
    return true;
  });
  if (is_cancelled) {
    requests_.clear();
    return false;
  }
  TraceBatch(tile, take);
  dropped_ += dropped_of_window_;
  lost_ += lost_of_window_;
  return true;
}

template <class Take>
void SampleTracer::TraceBatch(FilmTile* tile, Take take) {
  places_.resize(requests_.size());
  placer_.Place(requests_, places_);
  if (has_layers_) FindNearest(tile);
  const uint64_t rays_before = workspace_->rays.Total();
  radiance_.resize(requests_.size());
  if (has_layers_) layers_.resize(requests_.size());
  group_light_.resize(group_count_ * requests_.size());
  integrator_.Trace(requests_, workspace_.get(),
                    {radiance_, layers_, options_.layers.Has(Layer::kUv), wants_surface_,
                     group_light_, group_count_});
  for (size_t i = 0; i < requests_.size(); ++i) TakeSample(i, tile, take);
  counters_.Add(requests_.size(), workspace_->rays.Total() - rays_before);
  requests_.clear();
}

void SampleTracer::FindNearest(FilmTile* tile) {
  wants_surface_.clear();
  for (size_t i = 0; i < requests_.size(); ++i) {
    const SampleRequest& request = requests_[i];
    const Vec2 offset = places_[i].offset;
    PixelLayers& layers = tile->LayersAt(static_cast<int>(request.x), SamplePlacer::RowOf(request));
    const float off_centre = offset.x * offset.x + offset.y * offset.y;
    wants_surface_.push_back(layers.IsNearest(off_centre, request.index) ? 1 : 0);
  }
}

template <class Take>
void SampleTracer::TakeSample(size_t i, FilmTile* tile, Take take) {
  const int x = static_cast<int>(requests_[i].x), y = SamplePlacer::RowOf(requests_[i]);
  // Of those nearer than all before them the last one is the nearest.
  if (has_layers_ && wants_surface_[i]) tile->LayersAt(x, y).SetSurface(layers_[i].surface);
  const Rgb radiance = radiance_[i].ToRgb();
  const float factor = clamp_.IsOn() ? clamp_.Factor(radiance) : 1;
  const float weight = places_[i].weight;
  if (!take(x, y, radiance * factor, weight)) {
    dropped_of_window_.Add({x, y, requests_[i].index, radiance});
    return;
  }
  if (clamp_.IsOn()) SampleClamp::Count(radiance, factor, weight, &lost_of_window_);
  if (!has_layers_) return;
  const auto groups = std::span(group_light_).subspan(group_count_ * i, group_count_);
  if (factor < 1) {
    for (Rgb& light : layers_[i].light) light *= factor;
    for (Rgb& light : groups) light *= factor;
  }
  tile->AddLayers(x, y, layers_[i], weight);
  if (!groups.empty()) tile->AddLightGroups(x, y, groups, weight);
}

}  // namespace candela
