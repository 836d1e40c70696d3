#pragma once

#include <memory>

#include "lights/light.h"
#include "scene_spec/param_reader.h"

namespace candela {

struct LightContext;

/// Light from infinitely far away: parallel, or a round sun that is seen under an angle, as bright
/// in its middle as at its rim. Its direction is in world space; nodes do not turn it. `color` is
/// the irradiance at normal incidence, whatever the angle.
class DirectionalLight final : public Light {
 public:
  /// `direction` is where the light goes to; any length but 0. `angle_degrees` is the full angle
  /// under which it is seen, in [0, 180).
  DirectionalLight(Vec3 direction, Rgb color, float angle_degrees = 0);
  static std::unique_ptr<Light> Create(ParamReader* params, const LightContext& context);

  LightKind Kind() const override {
    return one_minus_cosine_ > 0 ? LightKind::kSky : LightKind::kPoint;
  }
  LightSample SampleIncident(Vec3) const override { return {to_light_, Spectrum(color_)}; }
  LightSample SampleIncident(Vec3 p, Vec2 u) const override;
  float PdfIncident(Vec3 p, const SurfacePoint& seen, Vec3 w) const override;
  Spectrum Emitted(const SurfacePoint& point, Vec3 w) const override;
  LightReach Reach() const override;
  EmissionSample SampleEmission(const Ball& scene, Vec2 u_position,
                                Vec2 u_direction) const override;
  EmissionPdf PdfEmission(const Ball& scene, const SurfacePoint& from, Vec3 w) const override;
  float Power(const Ball& scene) const override;

 private:
  bool IsSeenAlong(Vec3 w) const;

  Vec3 to_light_;
  Rgb color_;
  float one_minus_cosine_ = 0;  ///< Of half the angle.
  Rgb radiance_;
};

}  // namespace candela
