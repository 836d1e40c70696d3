#pragma once

#include <memory>

#include "lights/ies_file.h"
#include "lights/light.h"
#include "math/frame.h"
#include "scene_spec/param_reader.h"

namespace candela {

struct LightContext;

/// A point light whose intensity in each direction is that of a measured lamp.
class IesLight final : public Light {
 public:
  using Light::SampleIncident;

  /// `frame` is that of the directions of the profile, in the world; intensities are multiplied by
  /// `color`.
  IesLight(Vec3 position, const Frame& frame, std::shared_ptr<const IesProfile> profile, Rgb color);
  /// Null when its file cannot be read, which is reported.
  static std::unique_ptr<Light> Create(ParamReader* params, const LightContext& context);

  LightKind Kind() const override { return LightKind::kPoint; }
  LightSample SampleIncident(Vec3 p) const override;
  LightReach Reach() const override;
  EmissionSample SampleEmission(const Ball& scene, Vec2 u_position,
                                Vec2 u_direction) const override;
  EmissionPdf PdfEmission(const Ball& scene, const SurfacePoint& from, Vec3 w) const override;
  float Power(const Ball& scene) const override;

 private:
  Vec3 position_;
  Frame frame_;
  std::shared_ptr<const IesProfile> profile_;
  Rgb color_;
};

}  // namespace candela
