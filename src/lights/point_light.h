#pragma once

#include <memory>

#include "lights/light.h"
#include "scene_spec/param_reader.h"

namespace candela {

struct LightContext;

/// Shines from a point in all directions, with the intensity color / attenuation: at distance D it
/// gives color / (attenuation D^2).
class PointLight final : public Light {
 public:
  PointLight(Vec3 position, Rgb color, float attenuation)
      : position_(position), color_(color), attenuation_(attenuation) {}
  static std::unique_ptr<Light> Create(ParamReader* params, const LightContext& context);

  bool IsDelta() const override { return true; }
  LightSample SampleIncident(Vec3 p) const override;
  Spectrum Emitted(const SurfacePoint&, Vec3) const override { return {}; }

 private:
  Vec3 position_;
  Rgb color_;
  float attenuation_;
};

}  // namespace candela
