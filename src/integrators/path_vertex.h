#pragma once

#include <cstdint>
#include <limits>

#include "geometry/surface_point.h"
#include "materials/bsdf.h"
#include "materials/material.h"
#include "math/elementary.h"
#include "math/frame.h"
#include "math/spectrum.h"

namespace candela {

// What paths from the camera and paths from lights have in common.

inline constexpr uint32_t kUnlimited = std::numeric_limits<uint32_t>::max();

/// What a surface does with a path; each has a limit of its own.
enum BounceKind : uint8_t { kDiffuse, kMirror, kTransmission };

inline BounceKind KindOf(bool is_delta, bool is_transmission) {
  if (is_transmission) return kTransmission;
  return is_delta ? kMirror : kDiffuse;
}

/// A surface that a path has met.
struct PathVertex {
  SurfacePoint point;
  Vec3 wo;  ///< Unit vector to where the path comes from.
  const Material* material = nullptr;
  Bsdf bsdf;

  /// Finds out what the surface does with light, once all else is known.
  void Evaluate() {
    const Vec3 n = point.n_shading;
    bsdf.frame = Frame::FromNormal(Dot(n, wo) < 0 ? -n : n);
    material->Evaluate(point, &bsdf);
  }

  /// The medium beyond the surface, seen from where the path comes from.
  Rgb AbsorptionBeyond() const {
    return Dot(point.n_shading, bsdf.frame.z) > 0 ? material->Absorption() : Rgb();
  }
};

/// Whether light that goes through stays on one side of the true surface, or light that is
/// reflected goes through it. Where a shading normal says otherwise, light would leak.
inline bool IsOnWrongSide(const SurfacePoint& point, Vec3 wo, Vec3 wi, bool is_transmission) {
  const bool is_one_side = Dot(point.n_geometric, wo) * Dot(point.n_geometric, wi) > 0;
  return is_one_side == is_transmission;
}

/// The part of the light that a way through a medium leaves: Beer's law.
inline Spectrum Transmittance(Rgb absorption, float distance) {
  return Spectrum(Rgb{Exp(-absorption.x * distance), Exp(-absorption.y * distance),
                      Exp(-absorption.z * distance)});
}

}  // namespace candela
