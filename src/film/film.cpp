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

void PixelSums::Add(Rgb radiance, float sample_weight) {
  red.Add(radiance.x * sample_weight);
  green.Add(radiance.y * sample_weight);
  blue.Add(radiance.z * sample_weight);
  weight.Add(sample_weight);
}

Rgb PixelSums::Mean() const {
  const double divisor = weight.ToDouble();
  if (divisor == 0) return {};
  return ToFloat({red.ToDouble() / divisor, green.ToDouble() / divisor, blue.ToDouble() / divisor});
}

bool FilmTile::Add(int x, int y, Rgb radiance, float weight) {
  if (!IsUsable(radiance, takes_negative_)) return false;
  sums_[IndexOf(x, y)].Add(radiance, weight);
  return true;
}

Film::Film(PixelWindow window, Keep keep, Negative negative, LayerSet layers)
    : window_(window),
      takes_negative_(negative == Negative::kTake),
      recorded_(layers),
      colours_(3 * window.PixelCount()) {
  CHECK(window.x0 < window.x1 && window.y0 < window.y1);
  CHECK(keep == Keep::kColours || layers.IsEmpty());  // The sums that are kept hold no layers.
  for (size_t i = 0; i < kLayerCount; ++i) {
    if (!layers.Has(static_cast<Layer>(i))) continue;
    layer_words_[i] = ZeroedArray<uint32_t>(Layers()[i].channels.size() * window.PixelCount());
  }
  if (keep == Keep::kSums) sums_ = ZeroedArray<PixelSums>(window.PixelCount());
}

void Film::BeginTile(const PixelWindow& window, FilmTile* tile) const {
  CHECK(window_.Contains(window));
  tile->window_ = window;
  tile->takes_negative_ = takes_negative_;
  tile->sums_.assign(window.PixelCount(), PixelSums());
  tile->layers_.assign(recorded_.IsEmpty() ? 0 : window.PixelCount(), PixelLayers());
  if (!sums_) return;
  const auto width = static_cast<size_t>(window.Width());
  for (int y = window.y0; y < window.y1; ++y) {
    std::copy_n(&sums_[IndexOf(window.x0, y)], width,
                &tile->sums_[static_cast<size_t>(y - window.y0) * width]);
  }
}

void Film::EndTile(const FilmTile& tile) {
  const PixelSums* sums = tile.sums_.data();
  const PixelLayers* layers = tile.layers_.empty() ? nullptr : tile.layers_.data();
  for (int y = tile.window_.y0; y < tile.window_.y1; ++y) {
    for (int x = tile.window_.x0; x < tile.window_.x1; ++x, ++sums) {
      const size_t index = IndexOf(x, y);
      DevelopColour(index, *sums);
      if (sums_) sums_[index] = *sums;
      if (layers) DevelopLayers(index, *sums, *layers++);
    }
  }
}

void Film::DevelopColour(size_t index, const PixelSums& sums) {
  const Rgb colour = sums.Mean();
  colours_[3 * index] = colour.x;
  colours_[3 * index + 1] = colour.y;
  colours_[3 * index + 2] = colour.z;
}

std::span<const PixelSums> Film::Sums() const {
  CHECK(sums_);
  return {&sums_[0], window_.PixelCount()};
}

void Film::Restore(std::span<const PixelSums> sums) {
  CHECK(sums_ && sums.size() == window_.PixelCount());
  for (size_t i = 0; i < sums.size(); ++i) {
    sums_[i] = sums[i];
    DevelopColour(i, sums[i]);
  }
}

void Film::DevelopLayers(size_t index, const PixelSums& sums, const PixelLayers& layers) {
  for (size_t i = 0; i < kLayerCount; ++i) {
    if (!layer_words_[i]) continue;
    const LayerEntry& entry = Layers()[i];
    entry.develop(layers, sums, &layer_words_[i][entry.channels.size() * index]);
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
  return {&layer_words_[i][0], Layers()[i].channels.size() * window_.PixelCount()};
}

std::span<const float> Film::Row(int y) const {
  return {&colours_[3 * IndexOf(window_.x0, y)], 3 * static_cast<size_t>(window_.Width())};
}

}  // namespace candela
