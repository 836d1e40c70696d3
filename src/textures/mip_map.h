#pragma once

#include <cstdint>
#include <vector>

#include "image/raster.h"
#include "math/spectrum.h"
#include "math/vec.h"

namespace candela {

/// How a picture goes on beyond its edges.
enum class Wrap : uint8_t { kRepeat, kMirror, kClamp };

/// A picture with smaller and smaller copies of itself, each texel the mean of four: L. Williams,
/// "Pyramidal Parametrics", 1983. Coordinates go from 0 to 1 to the right and upwards; the centre
/// of the first texel is half a texel from the edge.
class MipMap {
 public:
  /// Of linear colours, three channels.
  MipMap(Image image, Wrap wrap);

  /// Between the four texels around `uv` in the two levels whose texels are about as wide as
  /// `width`, a part of the picture's larger side; 0 for the picture itself.
  Rgb Lookup(Vec2 uv, float width) const;

  int Width() const { return levels_[0].Width(); }
  int Height() const { return levels_[0].Height(); }
  int LevelCount() const { return static_cast<int>(levels_.size()); }
  uint64_t MemoryBytes() const;

 private:
  Rgb Bilinear(const Image& level, Vec2 uv) const;
  int Wrapped(int index, int size) const;

  std::vector<Image> levels_;
  Wrap wrap_;
};

}  // namespace candela
