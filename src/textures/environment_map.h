#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <utility>
#include <vector>

#include "base/diagnostics.h"
#include "image/raster.h"
#include "math/spectrum.h"

namespace candela {

/// A picture of the surroundings in longitude and latitude (see lat_long.h), with radiance without
/// an upper limit. Blends the four nearest texels, around the seam too. Immutable; called
/// concurrently.
class EnvironmentMap {
 public:
  /// `radiance` has three channels, finite and not negative. It is multiplied by `scale` and turned
  /// by `rotate_degrees` about +y, counter-clockwise seen from above.
  EnvironmentMap(Image radiance, float scale, float rotate_degrees);

  /// Reads an EXR, HDR, PFM, PNG or JPEG picture, without gamma; alpha is not used, grey stands
  /// for all colours. A file that cannot be read is reported at `asked`, the place that asks for
  /// it, one with wrong content under its own name. Negative values become 0, with a warning.
  static std::optional<EnvironmentMap> Load(const std::filesystem::path& path,
                                            const SourceLocation& asked, float scale,
                                            float rotate_degrees, Diagnostics* diagnostics);

  /// The radiance from a unit direction.
  Rgb Lookup(Vec3 direction) const;

  /// The means over the cells of a grid as fine as the picture, in its own longitude; add `Turn` to
  /// places in the world to get there. Colours are averaged too.
  std::vector<float> MeansOfCells() const;
  size_t Columns() const { return static_cast<size_t>(radiance_.Width()); }
  float Turn() const { return turn_; }

  uint64_t MemoryBytes() const { return radiance_.Samples().size_bytes(); }

 private:
  Rgb Texel(int x, int y) const;

  Image radiance_;
  float scale_;
  float turn_;  ///< Parts of a turn from a longitude in the world to that in the picture.
};

}  // namespace candela
