#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <new>
#include <span>
#include <string>
#include <vector>

#include "base/check.h"
#include "film/layers.h"
#include "film/pixel_estimate.h"
#include "math/spectrum.h"

namespace candela {

/// A rectangle of pixels of the whole picture; the origin is top left, the end is exclusive.
struct PixelWindow {
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0;

  int Width() const { return x1 - x0; }
  int Height() const { return y1 - y0; }
  size_t PixelCount() const { return static_cast<size_t>(Width()) * static_cast<size_t>(Height()); }
  /// The place of one of its pixels, counted row by row.
  size_t IndexOf(int x, int y) const {
    DCHECK(x >= x0 && x < x1 && y >= y0 && y < y1);
    return static_cast<size_t>(y - y0) * static_cast<size_t>(Width()) + static_cast<size_t>(x - x0);
  }
  bool Contains(const PixelWindow& other) const {
    return other.x0 >= x0 && other.y0 >= y0 && other.x1 <= x1 && other.y1 <= y1;
  }
  /// The pixels that are in both; empty when x0 >= x1 or y0 >= y1.
  PixelWindow Intersection(const PixelWindow& other) const {
    return {std::max(x0, other.x0), std::max(y0, other.y0), std::min(x1, other.x1),
            std::min(y1, other.y1)};
  }
  friend bool operator==(const PixelWindow&, const PixelWindow&) = default;
};

/// Zeros straight from the system: a page costs nothing until it is first touched, which the
/// workers do in parallel. For types whose zero bytes mean zero.
template <class T>
class ZeroedArray {
 public:
  ZeroedArray() = default;
  explicit ZeroedArray(size_t count) : items_(static_cast<T*>(std::calloc(count, sizeof(T)))) {
    if (items_ == nullptr) throw std::bad_alloc();
  }
  explicit operator bool() const { return items_ != nullptr; }
  T& operator[](size_t i) { return items_.get()[i]; }
  const T& operator[](size_t i) const { return items_.get()[i]; }

 private:
  struct Free {
    void operator()(T* items) const { std::free(items); }
  };
  std::unique_ptr<T, Free> items_;
};

/// The sums of a small rectangle, owned by one thread and used for one tile after the other. It
/// stays in the cache while a worker adds samples, and is what makes sums of a whole picture
/// unnecessary.
class FilmTile {
 public:
  /// Adds a sample of the pixel (x, y) of the whole picture, which must lie in the tile's window. A
  /// radiance that the film does not take (see `Film`) is dropped, weight included; then the
  /// answer is false.
  bool Add(int x, int y, Rgb radiance, float weight);

  /// Adds to the film's layers what else belongs to a sample that `Add` has taken.
  void AddLayers(int x, int y, const SampleLayers& sample, float weight) {
    layers_[IndexOf(x, y)].Add(sample, weight);
  }

  /// The same of its light by the groups of lights, as many as the film has.
  void AddLightGroups(int x, int y, std::span<const Rgb> lights, float weight);

  /// What layers say of a pixel apart from its light; there have to be some.
  PixelLayers& LayersAt(int x, int y) { return layers_[IndexOf(x, y)]; }

  const PixelWindow& Window() const { return window_; }

  /// Lets pixels of a series take the mean variance of the 4 x 4 around them for their own where it
  /// is more, until samples are added. A pixel that has not met what is rare and bright is too dark
  /// and looks too sure of that. The largest quarter does not count: an edge is not its
  /// neighbours'.
  void ShareVariance();

  /// What is known of a pixel; valid as long as the tile is not changed.
  PixelPart PartAt(int x, int y) const;

  /// Memory in bytes that a series takes of each pixel.
  static uint64_t BytesOfSeries(bool has_layers, size_t groups) {
    return sizeof(PixelSums) + sizeof(PixelSpread) + sizeof(Vec3d) +
           (has_layers ? sizeof(PixelLayers) : 0) + groups * sizeof(Vec3d);
  }

 private:
  friend class Film;

  size_t IndexOf(int x, int y) const { return window_.IndexOf(x, y); }
  template <class Visit>
  void ForEachIndex(const PixelWindow& window, Visit visit) const;

  PixelWindow window_;
  std::vector<PixelSums> sums_;
  std::vector<PixelSpread> spreads_;    ///< Empty when nobody asks how far colours may be off.
  std::vector<Vec3d> shared_variance_;  ///< Empty before `ShareVariance`.
  std::vector<PixelLayers> layers_;     ///< Empty for a film without layers.
  size_t group_count_ = 0;              ///< Of groups of lights that have layers.
  std::vector<Vec3d> light_groups_;     ///< So many for each pixel.
  bool takes_negative_ = true;
};

/// The picture under construction: the developed colour of every pixel of a window and, when it is
/// to be continued, its sums.
///
/// Workers fill it tile by tile: `BeginTile`, `FilmTile::Add` for every sample, `EndTile`.
/// Different tiles may be in work on different threads at the same time as long as their windows do
/// not overlap. Passes over the same pixels continue the sums, so 100 samples and later 400 more
/// give the bytes of 500.
///
/// A radiance with a NaN or infinite component is never taken, a negative one where it is said so.
class Film {
 public:
  enum class Keep {
    kColours,  ///< 12 bytes per pixel; each pixel gets all its samples in one tile
    kSums,     ///< 76 bytes per pixel, with layers 400 and 24 for each group of lights;
               ///< tiles may come again with more samples
  };
  enum class Negative {
    kTake,  ///< The course's model knows lights that take away.
    kDrop,  ///< Where light is what it is, a negative sample is a mistake.
  };

  /// `light_groups` are the names of the groups of lights, for `Layer::kLightGroups`.
  Film(PixelWindow window, Keep keep, Negative negative = Negative::kTake, LayerSet layers = {},
       std::span<const std::string> light_groups = {});

  const PixelWindow& Window() const { return window_; }

  /// Prepares the tile for samples of the pixels of `window`, which must lie within the film.
  void BeginTile(const PixelWindow& window, FilmTile* tile) const;

  /// Develops the pixels of the tile into the picture.
  void EndTile(const FilmTile& tile);

  /// Prepares the tile for a series of samples that the film does not keep, together with what they
  /// say of their own error. The window may reach beyond the film.
  void BeginSeries(const PixelWindow& window, FilmTile* tile) const;

  /// Develops the mean of two series of samples of the same window, as far as it lies within the
  /// film; may be done again when there are more.
  void EndSeries(const FilmTile& a, const FilmTile& b);

  /// What a tile with one sample of weight 1 for this pixel gives, at a fraction of the cost. For a
  /// film that keeps colours only, and no layers; different pixels may be set at the same time.
  /// False when the sample was dropped.
  bool SetOnlySample(int x, int y, Rgb radiance);

  /// Adds to the developed colour of a pixel, whose tile has ended or whose sample is set;
  /// different pixels may be added to at the same time.
  void AddToColour(int x, int y, Rgb radiance);

  /// The colour of a pixel of the whole picture; black before its tile has ended.
  Rgb Pixel(int x, int y) const;

  /// Red, green, blue of the pixels of a row, from left to right; y counts in the whole picture.
  std::span<const float> Row(int y) const;

  bool KeepsSums() const { return static_cast<bool>(sums_); }
  /// Of a film that keeps them, and has no layers: those of all pixels, row after row.
  std::span<const PixelSums> Sums() const;
  /// Goes on from such sums, as many as there are pixels.
  void Restore(std::span<const PixelSums> sums);

  LayerSet RecordedLayers() const { return recorded_; }

  /// What a file calls the layers of a row of the table: one, or one for each group of lights.
  std::vector<std::string> NamesOf(Layer layer) const;

  /// The values of a layer that is recorded, as `LayerEntry::develop` gives them, row after row.
  std::span<const uint32_t> LayerWords(Layer layer) const;

 private:
  size_t IndexOf(int x, int y) const { return window_.IndexOf(x, y); }
  void ClearTile(const PixelWindow& window, bool with_spread, FilmTile* tile) const;
  size_t ChannelCount(size_t layer) const;
  void SetColour(size_t index, Rgb colour);
  void Develop(size_t index, const PixelEstimate& pixel);

  PixelWindow window_;
  bool takes_negative_;
  LayerSet recorded_;
  std::vector<std::string> light_groups_;  ///< Empty when they are not recorded.
  ZeroedArray<float> colours_;
  ZeroedArray<PixelSums> sums_;       ///< null for `Keep::kColours`
  ZeroedArray<PixelSpread> spreads_;  ///< and these without layers too
  ZeroedArray<PixelLayers> layers_;
  ZeroedArray<Vec3d> group_sums_;                               ///< As in `FilmTile`.
  std::array<ZeroedArray<uint32_t>, kLayerCount> layer_words_;  ///< null for those not recorded
};

}  // namespace candela
