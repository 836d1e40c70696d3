#include "film/film.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/check.h"

namespace candela {
namespace {

/// Written so that NaN is not usable.
bool IsUsable(float radiance, bool takes_negative) {
  return std::abs(radiance) <= std::numeric_limits<float>::max() &&
         (takes_negative || radiance >= 0);
}

bool IsUsable(Rgb radiance, bool takes_negative) {
  return IsUsable(radiance.x, takes_negative) && IsUsable(radiance.y, takes_negative) &&
         IsUsable(radiance.z, takes_negative);
}

}  // namespace

bool FilmTile::Add(int x, int y, Rgb radiance, float weight) {
  if (!IsUsable(radiance, takes_negative_)) return false;
  const size_t index = IndexOf(x, y);
  sums_[index].Add(radiance, weight);
  if (!spreads_.empty()) spreads_[index].Add(radiance, weight);
  return true;
}

void FilmTile::AddLightGroups(int x, int y, std::span<const Rgb> lights, float weight) {
  DCHECK(lights.size() == group_count_);
  Vec3d* sums = light_groups_.data() + group_count_ * IndexOf(x, y);
  for (const Rgb& light : lights) *sums++ += UsableInLayers(light * weight);
}

namespace {

/// The mean without the largest quarter.
double MeanOfLower(std::span<double> values) {
  std::sort(values.begin(), values.end());
  const size_t count = values.size() - values.size() / 4;
  double sum = 0;
  for (size_t i = 0; i < count; ++i) sum += values[i];
  return sum / static_cast<double>(count);
}

}  // namespace

void FilmTile::ShareVariance() {
  constexpr int kSide = 4;
  shared_variance_.resize(sums_.size());
  for (int y0 = window_.y0; y0 < window_.y1; y0 += kSide) {
    for (int x0 = window_.x0; x0 < window_.x1; x0 += kSide) {
      const PixelWindow square = window_.Intersection({x0, y0, x0 + kSide, y0 + kSide});
      std::array<std::array<double, kSide * kSide>, 3> variances;
      size_t count = 0;
      ForEachIndex(square, [&](size_t i) {
        const Vec3d variance = spreads_[i].Variance(sums_[i]);
        for (int axis = 0; axis < 3; ++axis) variances[axis][count] = variance[axis];
        ++count;
      });
      Vec3d shared;
      for (int axis = 0; axis < 3; ++axis) {
        shared[axis] = MeanOfLower({variances[axis].data(), count});
      }
      ForEachIndex(square, [&](size_t i) { shared_variance_[i] = shared; });
    }
  }
}

template <class Visit>
void FilmTile::ForEachIndex(const PixelWindow& window, Visit visit) const {
  for (int y = window.y0; y < window.y1; ++y) {
    for (int x = window.x0; x < window.x1; ++x) visit(IndexOf(x, y));
  }
}

PixelPart FilmTile::PartAt(int x, int y) const {
  const size_t index = IndexOf(x, y);
  return {&sums_[index], spreads_.empty() ? nullptr : &spreads_[index],
          layers_.empty() ? nullptr : &layers_[index],
          shared_variance_.empty() ? Vec3d() : shared_variance_[index],
          std::span(light_groups_).subspan(group_count_ * index, group_count_)};
}

Film::Film(PixelWindow window, Keep keep, Negative negative, LayerSet layers,
           std::span<const std::string> light_groups)
    : window_(window),
      takes_negative_(negative == Negative::kTake),
      recorded_(layers),
      colours_(3 * window.PixelCount()) {
  CHECK(window.x0 < window.x1 && window.y0 < window.y1);
  if (layers.Has(Layer::kLightGroups)) {
    CHECK(!light_groups.empty());
    light_groups_.assign(light_groups.begin(), light_groups.end());
  }
  for (size_t i = 0; i < kLayerCount; ++i) {
    if (!layers.Has(static_cast<Layer>(i))) continue;
    layer_words_[i] = ZeroedArray<uint32_t>(ChannelCount(i) * window.PixelCount());
  }
  if (keep == Keep::kColours) return;
  sums_ = ZeroedArray<PixelSums>(window.PixelCount());
  if (layers.IsEmpty()) return;
  spreads_ = ZeroedArray<PixelSpread>(window.PixelCount());
  layers_ = ZeroedArray<PixelLayers>(window.PixelCount());
  if (light_groups_.empty()) return;
  group_sums_ = ZeroedArray<Vec3d>(light_groups_.size() * window.PixelCount());
}

void Film::ClearTile(const PixelWindow& window, bool with_spread, FilmTile* tile) const {
  const size_t count = window.PixelCount();
  tile->window_ = window;
  tile->takes_negative_ = takes_negative_;
  tile->sums_.assign(count, PixelSums());
  tile->spreads_.assign(with_spread ? count : 0, PixelSpread());
  tile->shared_variance_.clear();
  tile->layers_.assign(recorded_.IsEmpty() ? 0 : count, PixelLayers());
  tile->group_count_ = light_groups_.size();
  tile->light_groups_.assign(light_groups_.size() * count, Vec3d());
}

void Film::BeginTile(const PixelWindow& window, FilmTile* tile) const {
  CHECK(window_.Contains(window));
  ClearTile(window, !recorded_.IsEmpty(), tile);
  if (!sums_) return;
  const auto width = static_cast<size_t>(window.Width());
  for (int y = window.y0; y < window.y1; ++y) {
    const size_t from = IndexOf(window.x0, y), to = tile->IndexOf(window.x0, y);
    std::copy_n(&sums_[from], width, &tile->sums_[to]);
    if (!layers_) continue;
    std::copy_n(&spreads_[from], width, &tile->spreads_[to]);
    std::copy_n(&layers_[from], width, &tile->layers_[to]);
    if (!group_sums_) continue;
    const size_t groups = light_groups_.size();
    std::copy_n(&group_sums_[groups * from], groups * width, &tile->light_groups_[groups * to]);
  }
}

void Film::EndTile(const FilmTile& tile) {
  const PixelWindow& window = tile.window_;
  for (int y = window.y0; y < window.y1; ++y) {
    for (int x = window.x0; x < window.x1; ++x) {
      const size_t index = IndexOf(x, y);
      const PixelPart part = tile.PartAt(x, y);
      if (part.layers) {
        Develop(index, PixelEstimate({&part, 1}));
      } else {
        SetColour(index, part.sums->Mean());
      }
      if (!sums_) continue;
      sums_[index] = *part.sums;
      if (!layers_) continue;
      spreads_[index] = *part.spread;
      layers_[index] = *part.layers;
      if (!group_sums_) continue;
      std::ranges::copy(part.light_groups, &group_sums_[light_groups_.size() * index]);
    }
  }
}

void Film::BeginSeries(const PixelWindow& window, FilmTile* tile) const {
  CHECK(!sums_);
  ClearTile(window, true, tile);
}

void Film::EndSeries(const FilmTile& a, const FilmTile& b) {
  CHECK(a.window_ == b.window_);
  const PixelWindow window = a.window_.Intersection(window_);
  for (int y = window.y0; y < window.y1; ++y) {
    for (int x = window.x0; x < window.x1; ++x) {
      const std::array parts = {a.PartAt(x, y), b.PartAt(x, y)};
      Develop(IndexOf(x, y), PixelEstimate(parts));
    }
  }
}

void Film::SetColour(size_t index, Rgb colour) {
  colours_[3 * index] = colour.x;
  colours_[3 * index + 1] = colour.y;
  colours_[3 * index + 2] = colour.z;
}

void Film::Develop(size_t index, const PixelEstimate& pixel) {
  SetColour(index, pixel.Colour());
  for (size_t i = 0; i < kLayerCount; ++i) {
    if (!layer_words_[i]) continue;
    Layers()[i].develop(pixel, &layer_words_[i][ChannelCount(i) * index]);
  }
}

std::span<const PixelSums> Film::Sums() const {
  CHECK(sums_ && !layers_);
  return {&sums_[0], window_.PixelCount()};
}

void Film::Restore(std::span<const PixelSums> sums) {
  CHECK(sums_ && !layers_ && sums.size() == window_.PixelCount());
  for (size_t i = 0; i < sums.size(); ++i) {
    sums_[i] = sums[i];
    SetColour(i, sums[i].Mean());
  }
}

bool Film::SetOnlySample(int x, int y, Rgb radiance) {
  DCHECK(!sums_ && recorded_.IsEmpty());
  if (!IsUsable(radiance, takes_negative_)) return false;
  // 0, and floats from 2^-20 on, are multiples of what a sum resolves.
  const auto developed = [](float value) {
    const bool is_exact = value == 0 || (value >= 0x1p-20f && value <= ExactSum::kLargestTerm);
    return is_exact ? value : static_cast<float>(ExactSum::OfOne(value));
  };
  float* colour = &colours_[3 * IndexOf(x, y)];
  colour[0] = developed(radiance.x);
  colour[1] = developed(radiance.y);
  colour[2] = developed(radiance.z);
  return true;
}

void Film::AddToColour(int x, int y, Rgb radiance) {
  float* colour = &colours_[3 * IndexOf(x, y)];
  colour[0] += radiance.x;
  colour[1] += radiance.y;
  colour[2] += radiance.z;
}

Rgb Film::Pixel(int x, int y) const {
  const float* colour = &colours_[3 * IndexOf(x, y)];
  return {colour[0], colour[1], colour[2]};
}

std::span<const uint32_t> Film::LayerWords(Layer layer) const {
  const auto i = static_cast<size_t>(layer);
  CHECK(layer_words_[i]);
  return {&layer_words_[i][0], ChannelCount(i) * window_.PixelCount()};
}

std::vector<std::string> Film::NamesOf(Layer layer) const {
  const LayerEntry& entry = EntryOf(layer);
  if (!entry.is_of_groups) return {std::string(entry.name)};
  std::vector<std::string> names;
  for (const std::string& group : light_groups_) names.push_back("light_group_" + group);
  return names;
}

/// Of a pixel.
size_t Film::ChannelCount(size_t layer) const {
  const LayerEntry& entry = Layers()[layer];
  return entry.channels.size() * (entry.is_of_groups ? light_groups_.size() : 1);
}

std::span<const float> Film::Row(int y) const {
  return {&colours_[3 * IndexOf(window_.x0, y)], 3 * static_cast<size_t>(window_.Width())};
}

}  // namespace candela
