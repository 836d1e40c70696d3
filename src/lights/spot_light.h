#pragma once

#include <memory>

#include "lights/falloff.h"
#include "lights/light.h"
#include "scene_spec/param_reader.h"

namespace candela {

struct LightContext;

/// A point light that shines into a cone around a direction: fully within its inner part, then
/// fading smoothly to nothing at its rim.
class SpotLight final : public Light {
 public:
  using Light::SampleIncident;

  /// Of the cone.
  struct Beam {
    Vec3 direction;      ///< Where it goes; any length but 0.
    float cosine_inner;  ///< Of the angle off the direction up to which it is bright,
    float cosine_outer;  ///< and of that from which on it is dark; not above the inner one.
  };
  SpotLight(Vec3 position, const Beam& beam, Rgb color, Falloff falloff);
  static std::unique_ptr<Light> Create(ParamReader* params, const LightContext& context);

  LightKind Kind() const override { return LightKind::kPoint; }
  LightSample SampleIncident(Vec3 p) const override;
  LightReach Reach() const override;
  EmissionSample SampleEmission(const Ball& scene, Vec2 u_position,
                                Vec2 u_direction) const override;
  EmissionPdf PdfEmission(const Ball& scene, const SurfacePoint& from, Vec3 w) const override;
  float Power(const Ball& scene) const override;
  bool CanBeSentOut() const override { return falloff_.IsOfLight(); }

 private:
  /// From 1 in the inner cone to 0 outside, by the cosine of the angle off the direction.
  float Brightness(float cosine) const;

  Vec3 position_;
  Vec3 direction_;
  float cosine_inner_, cosine_outer_;
  Rgb color_;
  Falloff falloff_;
};

}  // namespace candela
