#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string_view>

#include "math/vec.h"
#include "sampling/sample_layers.h"

namespace candela {

class PixelEstimate;

/// What a picture can hold beside its colours.
enum class Layer : uint8_t {
  kDepth,
  kPosition,
  kNormal,
  kGeometricNormal,
  kAlbedo,
  kUv,
  kObjectId,
  kMaterialId,
  kDirect,
  kIndirect,
  kEmission,
  kSampleCount,
  kStandardError,
  kLightGroups,
};
inline constexpr size_t kLayerCount = 14;

/// A set of layers.
class LayerSet {
 public:
  constexpr LayerSet() = default;
  constexpr explicit LayerSet(std::initializer_list<Layer> layers) {
    for (const Layer layer : layers) Add(layer);
  }

  constexpr void Add(Layer layer) { bits_ |= Bit(layer); }
  constexpr bool Has(Layer layer) const { return (bits_ & Bit(layer)) != 0; }
  constexpr bool IsEmpty() const { return bits_ == 0; }
  friend constexpr bool operator==(LayerSet, LayerSet) = default;

 private:
  static constexpr uint32_t Bit(Layer layer) { return uint32_t{1} << static_cast<uint32_t>(layer); }
  uint32_t bits_ = 0;
};

/// Everything that the layers of a pixel have to remember, apart from the sum of its weights and
/// its spread. The samples of a pixel come in their order, whoever renders it, so that plain sums
/// are always the same.
class PixelLayers {
 public:
  /// Whether a sample is nearer to the middle of the pixel than all that this was asked of before,
  /// of equally near ones the first; `distance` is the square of that. Then its surface is that of
  /// the pixel, whether its light counts or not.
  bool IsNearest(float distance, uint32_t index);
  void SetSurface(const SampleLayers::Surface& surface) { surface_ = surface; }
  /// Whether its nearest sample is nearer than that of another series of samples.
  bool IsNearerThan(const PixelLayers& other) const;

  /// Adds the light of a sample that the colours have taken.
  void Add(const SampleLayers& sample, float weight);

  const SampleLayers::Surface& Surface() const { return surface_; }
  // Weighted sums.
  Vec3d Albedo() const { return SumOf(0); }
  /// See `SampleLayers::light`. The three parts add up to the colour of the pixel, but for
  /// rounding.
  Vec3d Light(size_t times_scattered) const { return SumOf(1 + times_scattered); }

 private:
  Vec3d SumOf(size_t colour) const {
    return {sums_[3 * colour], sums_[3 * colour + 1], sums_[3 * colour + 2]};
  }

  std::array<double, sizeof(SampleColours) / sizeof(float)>
      sums_{};  ///< Of its numbers, in their order.
  SampleLayers::Surface surface_;
  float distance_ = 0;  ///< Of the nearest sample, if there is one.
  uint32_t index_ = 0;
  bool has_nearest_ = false;
};

/// What is recorded may be infinite or no number where the radiance is neither: a colour of 0 can
/// hide it. Then it counts as the largest term of the colours, or as nothing.
Vec3d UsableInLayers(Rgb value);

/// A row of the table of layers.
struct LayerEntry {
  std::string_view name;      ///< Of the layer in the command line and in the file.
  std::string_view channels;  ///< One letter for each of its channels.
  bool is_whole;              ///< They are whole numbers, not floats.
  std::string_view description;
  /// Stores the values of a pixel, one 32-bit word for each channel as a file holds it: the bits of
  /// a float, or a whole number.
  void (*develop)(const PixelEstimate& pixel, uint32_t* words);
  /// As many layers as the scene has groups of lights, one behind the other. Not every integrator
  /// has them.
  bool is_of_groups = false;
};

/// All layers; the index of a row is the number of its `Layer`.
std::span<const LayerEntry, kLayerCount> Layers();

inline const LayerEntry& EntryOf(Layer layer) {
  return Layers()[static_cast<size_t>(layer)];
}

}  // namespace candela
