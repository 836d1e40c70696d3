#pragma once

#include "lights/light.h"

namespace candela {

/// Surroundings that are equally bright in all directions.
class EvenSkyLight final : public Light {
 public:
  explicit EvenSkyLight(const Spectrum& radiance) : radiance_(radiance) {}

  LightKind Kind() const override { return LightKind::kSky; }
  LightSample SampleIncident(Vec3) const override { return {{}, {}, 0, 0}; }
  LightSample SampleIncident(Vec3 p, Vec2 u) const override;
  float PdfIncident(Vec3 p, const SurfacePoint& seen, Vec3 w) const override;
  Spectrum Emitted(const SurfacePoint&, Vec3) const override { return radiance_; }
  LightReach Reach() const override;
  EmissionSample SampleEmission(const Ball& scene, Vec2 u_position,
                                Vec2 u_direction) const override;
  EmissionPdf PdfEmission(const Ball& scene, const SurfacePoint& from, Vec3 w) const override;
  float Power(const Ball& scene) const override;

 private:
  Spectrum radiance_;
};

}  // namespace candela
