#pragma once

#include <memory>

#include "lights/light.h"
#include "scene_spec/param_reader.h"

namespace candela {

struct LightContext;

/// Makes the object of its node a lamp that shines with the same radiance from every point of both
/// sides in every direction.
class AreaLight final : public Light {
 public:
  explicit AreaLight(Spectrum radiance) : radiance_(radiance) {}
  static std::unique_ptr<Light> Create(ParamReader* params, const LightContext& context);

  bool IsDelta() const override { return false; }
  LightSample SampleIncident(Vec3) const override { return {}; }
  Spectrum Emitted(const SurfacePoint&, Vec3) const override { return radiance_; }

 private:
  Spectrum radiance_;
};

}  // namespace candela
