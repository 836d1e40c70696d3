#pragma once

#include <memory>

#include "lights/light.h"
#include "scene_spec/param_reader.h"

namespace candela {

struct LightContext;

/// Parallel light from infinitely far away. Its direction is in world space; nodes do not turn it.
class DirectionalLight final : public Light {
 public:
  /// `direction` is where the light goes to; any length but 0.
  DirectionalLight(Vec3 direction, Rgb color)
      : to_light_(-NormalizeAnyLength(direction)), color_(color) {}
  static std::unique_ptr<Light> Create(ParamReader* params, const LightContext& context);

  bool IsDelta() const override { return true; }
  LightSample SampleIncident(Vec3) const override { return {to_light_, Spectrum(color_)}; }
  Spectrum Emitted(const SurfacePoint&, Vec3) const override { return {}; }

 private:
  Vec3 to_light_;
  Rgb color_;
};

}  // namespace candela
