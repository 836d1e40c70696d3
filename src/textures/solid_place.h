#pragma once

#include <cstdint>
#include <optional>

#include "geometry/surface_point.h"
#include "math/transform.h"
#include "math/vec.h"
#include "scene_spec/param_reader.h"

namespace candela {

/// Where in a texture that fills space a point of a surface lies: its coordinates in the space of
/// its object, in that of the world, or its texture coordinates with a third one of 0, which are
/// scaled, then turned, then moved.
class SolidPlace {
 public:
  struct Place {
    Vec3 p;      ///< Each component below 2^22; beyond, where floats know no places in between, 0.
    float size;  ///< How much longer what lies in the surface is here than in the world, at most.
  };

  SolidPlace() = default;
  /// Reads `space`, `scale`, `rotation` and `offset`.
  static SolidPlace Create(ParamReader* params);
  /// The same without texture coordinates to choose.
  static SolidPlace CreateOfSpace(ParamReader* params);

  Place At(const SurfacePoint& point) const;
  /// The shading normal there, of any length.
  Vec3 NormalAt(const SurfacePoint& point) const;

 private:
  enum class Space : uint8_t { kObject, kWorld, kUv };

  static SolidPlace Placed(ParamReader* params, Space space);
  /// Nothing where a point is where it counts.
  std::optional<Transform> IntoObject(const SurfacePoint& point) const;

  Space space_ = Space::kObject;
  Transform place_from_space_;
};

}  // namespace candela
