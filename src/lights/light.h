#pragma once

#include <limits>

#include "geometry/surface_point.h"
#include "math/spectrum.h"
#include "math/vec.h"

namespace candela {

/// Light that reaches a point from one light source.
struct LightSample {
  Vec3 direction;     ///< Unit vector from the point to the light; 0 when no light comes from it.
  Spectrum radiance;  ///< For a light without extent: what it adds to the irradiance at normal
                      ///< incidence.
  float distance =
      std::numeric_limits<float>::max();  ///< The largest float when it is infinitely far.
};

/// A source of light. Immutable; called concurrently.
class Light {
 public:
  virtual ~Light() = default;

  /// True for a light that illuminates from a single direction, so that no ray can hit it. The
  /// others are the surface of an object and found by hitting it.
  virtual bool IsDelta() const = 0;

  /// The light that a delta light sends to `p`, if nothing is in the way.
  virtual LightSample SampleIncident(Vec3 p) const = 0;

  /// The radiance that leaves the light's surface at `point` in the unit direction `w`.
  virtual Spectrum Emitted(const SurfacePoint& point, Vec3 w) const = 0;
};

}  // namespace candela
