#pragma once

#include <algorithm>

#include "geometry/surface_point.h"
#include "materials/bsdf.h"
#include "materials/medium.h"
#include "math/spectrum.h"

namespace candela {

/// The terms of the Phong model at a point: Phong, "Illumination for Computer Generated Pictures",
/// 1975, in the form of the course. Not physical: the numbers multiply light as they are.
struct PhongTerms {
  Rgb ambient;  ///< Multiplies the ambient light.
  Rgb diffuse;
  Rgb specular;  ///< Of highlights and of mirror reflection alike.
  float shininess = 0;
};

/// What distribution ray tracing knows of a Phong surface beyond that: Cook, Porter and Carpenter,
/// "Distributed Ray Tracing", 1984.
struct PhongOptics {
  /// How far what it mirrors is spread about the mirrored direction; 0 for a sharp mirror.
  float reflection_roughness = 0;
  Rgb transmittance;  ///< Of the light that Fresnel's equations let through, each from 0 to 1.
  float ior = 1;      ///< The refractive index of the body behind the surface, over that of air.
  Rgb absorption;     ///< What that takes of the light, per unit of length; not negative.

  bool IsTransparent() const { return transmittance != Rgb(); }
};

/// The exponent of the Phong highlight that looks as wide as that of facets with the roughness
/// `alpha`.
inline float ShininessOf(float alpha) {
  constexpr float kSharpest = 2000;
  return std::min(0.5f / std::max(alpha * alpha, 1e-6f), kSharpest);
}

/// What a surface does with light. Immutable; called concurrently.
class Material {
 public:
  virtual ~Material() = default;

  /// For the `whitted` integrator.
  virtual PhongTerms Phong(const SurfacePoint& point) const = 0;

  /// For that integrator too, where it takes more than one ray.
  virtual PhongOptics Optics(const SurfacePoint& /*point*/) const { return {}; }

  /// Whether that can say more than that there is nothing to know.
  virtual bool HasOptics() const { return false; }

  /// For light transport: adds the lobes at `point` to a Bsdf whose frame is set.
  virtual void Evaluate(const SurfacePoint& point, Bsdf* bsdf) const = 0;

  /// What a body of it is filled with, unless a scene says otherwise; null when no light gets in.
  virtual const Medium* Body() const { return nullptr; }

  /// The share of the surface at a point where nothing is, and light goes on as it came: that of
  /// the lobes of the kind `kHole`.
  virtual float Transparency(const SurfacePoint& /*point*/) const { return 0; }

  /// Whether that can be above 0.
  virtual bool HasHoles() const { return false; }

  /// How many lobes `Evaluate` adds at most.
  virtual int MostLobes() const { return 1; }

  /// Whether `Evaluate` turns the frame's z axis away from the shading normal.
  virtual bool BendsNormals() const { return false; }

  /// Whether the points that it is asked about need texture coordinates.
  virtual bool NeedsTextureCoordinates() const { return false; }

  /// False when `Evaluate` cannot say all that the material does.
  virtual bool IsPhysical() const = 0;
};

}  // namespace candela
