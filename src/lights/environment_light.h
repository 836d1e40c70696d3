#pragma once

#include <span>

#include "lights/light.h"
#include "sampling/distribution.h"
#include "textures/cube_map.h"
#include "textures/environment_map.h"

namespace candela {

/// The surroundings as a light: directions are drawn by how bright a picture of them is there,
/// after the mean of the colours times the sine of the angle to the zenith. Refers to the picture.
class EnvironmentLight final : public Light {
 public:
  explicit EnvironmentLight(const EnvironmentMap& map);
  /// A cube map is looked at through a grid in longitude and latitude; what falls through it is
  /// found by rays.
  explicit EnvironmentLight(const CubeMap& map);

  LightKind Kind() const override { return LightKind::kSky; }
  LightSample SampleIncident(Vec3) const override { return {{}, {}, 0, 0}; }
  LightSample SampleIncident(Vec3 p, Vec2 u) const override;
  float PdfIncident(Vec3 p, const SurfacePoint& seen, Vec3 w) const override;
  Spectrum Emitted(const SurfacePoint&, Vec3 w) const override { return Radiance(-w); }
  LightReach Reach() const override { return {irradiance_, true, {}, 0}; }
  EmissionSample SampleEmission(const Ball& scene, Vec2 u_position,
                                Vec2 u_direction) const override;
  EmissionPdf PdfEmission(const Ball& scene, const SurfacePoint& from, Vec3 w) const override;
  float Power(const Ball& scene) const override;

 private:
  /// The means of cells times the solid angles of their rows, in place.
  std::span<const float> WeighBySolidAngle(std::span<float> means, size_t columns);
  Spectrum Radiance(Vec3 direction) const;
  /// How often a direction of emission is drawn from the whole sphere, whatever the grid says: that
  /// does not know what lies between its points, or beside something much brighter. Paths from the
  /// camera find such light by rays.
  float EvenShare() const { return cube_map_ ? 0.125f : 0.03f; }

  const EnvironmentMap* map_ = nullptr;
  const CubeMap* cube_map_ = nullptr;
  float turn_ = 0;        ///< From longitudes in the world to those of the grid.
  float irradiance_ = 0;  ///< On a plane under a sky of the mean radiance.
  Distribution2D distribution_;
};

}  // namespace candela
