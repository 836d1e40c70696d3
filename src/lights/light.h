#pragma once

#include <limits>
#include <memory>

#include "geometry/ball.h"
#include "geometry/surface_point.h"
#include "math/spectrum.h"
#include "math/vec.h"
#include "shapes/surface_sampler.h"

namespace candela {

/// Light that reaches a point from one light source.
struct LightSample {
  Vec3 direction;     ///< Unit vector from the point to the light; 0 when no light comes from it.
  Spectrum radiance;  ///< For a light without extent: what it adds to the irradiance at normal
                      ///< incidence.
  float distance =
      std::numeric_limits<float>::max();  ///< The largest float when it is infinitely far. To a
                                          ///< surface a little short, so that a ray of this length
                                          ///< does not meet the light itself.
  float pdf = 1;  ///< Of the direction, over solid angle; 1 for a light without extent, 0 when
                  ///< nothing was drawn.
};

/// Light that leaves a light source along a ray.
struct EmissionSample {
  /// Where it starts: on the surface of the light with its normal, else without one. Of a light in
  /// the sky, outside of the scene.
  SurfacePoint origin;
  Vec3 direction;  ///< Where it goes; a unit vector.
  Spectrum flux;   ///< Radiance times cosine over both densities; black when nothing was drawn.
  float pdf_position = 0;   ///< Of the origin, over area; 1 when there is only one.
  float pdf_direction = 0;  ///< Of the direction, over solid angle; 1 when there is only one.
};

/// The densities of that.
struct EmissionPdf {
  float position, direction;
};

/// Who can meet a light besides a sample of it.
enum class LightKind {
  kPoint,    ///< Nobody: it has no extent.
  kSurface,  ///< Rays that hit its object.
  kSky,      ///< Rays that leave the scene: it has an extent, infinitely far away.
};

/// What is to be known of a light to judge from afar how much it may give.
struct LightReach {
  /// Of a light in the scene the flux (in 4 pi of its radiance over area and solid angle), of one
  /// that is infinitely far the irradiance at normal incidence; the mean of the colours. 0 for a
  /// light that is found by rays alone.
  float power = 0;
  bool is_far = false;
  Vec3 center;  ///< Of a ball around it, unless it is far.
  float radius = 0;

  /// Unless it is 0, the light goes around this unit direction only: to where the cosine of the
  /// angle to it is at least `least_cosine`.
  Vec3 axis{};
  float least_cosine = -1;
  bool is_flat = false;  ///< It fades with the cosine to the axis, on both sides of its plane.
};

/// A source of light. Immutable once its scene is compiled; called concurrently.
class Light {
 public:
  virtual ~Light() = default;

  virtual LightKind Kind() const = 0;

  /// Whether it is the surface of an object. The others illuminate from a single direction, or from
  /// few enough around one that the integrator `whitted` may take it so.
  bool IsSurface() const { return Kind() == LightKind::kSurface; }

  /// The light that reaches `p` from a light that is no surface, as if all of it came from its
  /// middle, if nothing is in the way.
  virtual LightSample SampleIncident(Vec3 p) const = 0;

  /// Light that reaches `p` from one of the directions from which it comes, drawn with two numbers
  /// in [0, 1), if nothing is in the way.
  virtual LightSample SampleIncident(Vec3 p, Vec2 /*u*/) const { return SampleIncident(p); }

  /// The density over solid angle with which that draws the unit direction `w` from `p`; `seen` is
  /// the point of its surface there, and is not looked at for a light in the sky. 0 where it draws
  /// nothing: such light is found by rays alone.
  virtual float PdfIncident(Vec3 /*p*/, const SurfacePoint& /*seen*/, Vec3 /*w*/) const {
    return 0;
  }

  /// The radiance that leaves the light's surface at `point` in the unit direction `w`. From a
  /// light in the sky, what comes to the scene along `w`, wherever the point is.
  virtual Spectrum Emitted(const SurfacePoint& /*point*/, Vec3 /*w*/) const { return {}; }

  virtual LightReach Reach() const = 0;

  /// Light that it sends out, drawn with two pairs of numbers in [0, 1), if nothing is in the way.
  /// The mean of the flux is all the light that it sends; from the sky, into `scene`, a ball around
  /// all that it can light, of which it draws a disk across the direction.
  virtual EmissionSample SampleEmission(const Ball& scene, Vec2 u_position,
                                        Vec2 u_direction) const = 0;

  /// The densities with which that draws the origin `from` and the unit direction `w`; they are 1
  /// where there is nothing to draw.
  virtual EmissionPdf PdfEmission(const Ball& scene, const SurfacePoint& from, Vec3 w) const = 0;

  /// The mean over the colours of the flux that `SampleEmission` gives, colours that take light
  /// away taken as positive; nearly, where it is not known exactly.
  virtual float Power(const Ball& scene) const = 0;

  /// Whether it gives light that `SampleEmission` cannot draw, since its surface cannot be sampled.
  virtual bool IsFoundByHitsAlone() const { return false; }

  /// False when its light falls with the distance as no light does that is sent out. Then
  /// `SampleEmission` draws nothing.
  virtual bool CanBeSentOut() const { return true; }

  /// Called once while the scene is compiled, for a light that is the surface of an object: what
  /// draws points of it, which may be null, and a ball around it.
  virtual void SetSurface(std::unique_ptr<const SurfaceSampler> /*sampler*/, Vec3 /*center*/,
                          float /*radius*/) {}
};

/// The mean of red, green and blue: how lights are compared with each other.
inline float MeanOf(const Rgb& color) {
  return (color.x + color.y + color.z) * (1.0f / 3);
}

}  // namespace candela
