#pragma once

#include <cstdint>

#include "geometry/surface_point.h"
#include "math/spectrum.h"

namespace candela {

/// A colour that varies over surfaces. Immutable; called concurrently.
class Texture {
 public:
  virtual ~Texture() = default;

  /// The colour at a point whose texture coordinates and way to object space are set. Finite for
  /// all points. Where the point knows its footprint, the mean over about that width.
  virtual Rgb Lookup(const SurfacePoint& point) const = 0;

  /// False when the colour is the same everywhere.
  virtual bool NeedsTextureCoordinates() const { return true; }

  virtual uint64_t MemoryBytes() const { return 0; }
};

}  // namespace candela
