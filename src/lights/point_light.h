#pragma once

#include <memory>

#include "lights/falloff.h"
#include "lights/light.h"
#include "scene_spec/param_reader.h"

namespace candela {

struct LightContext;

/// Shines from a point in all directions. With an attenuation for its falloff the intensity is
/// color / attenuation: at distance D it gives color / (attenuation D^2).
class PointLight final : public Light {
 public:
  using Light::SampleIncident;

  PointLight(Vec3 position, Rgb color, Falloff falloff)
      : position_(position), color_(color), falloff_(falloff) {}
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
  Vec3 position_;
  Rgb color_;
  Falloff falloff_;
};

}  // namespace candela
