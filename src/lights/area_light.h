#pragma once

#include <memory>

#include "lights/light.h"
#include "scene_spec/param_reader.h"

namespace candela {

struct LightContext;

/// Makes the object of its node a lamp that shines with the same radiance from every point, in
/// every direction on the side of the normal, or on both sides.
class AreaLight final : public Light {
 public:
  using Light::SampleIncident;

  AreaLight(Spectrum radiance, bool is_two_sided)
      : radiance_(radiance), is_two_sided_(is_two_sided) {}
  static std::unique_ptr<Light> Create(ParamReader* params, const LightContext& context);

  LightKind Kind() const override { return LightKind::kSurface; }
  LightSample SampleIncident(Vec3) const override { return {{}, {}, 0, 0}; }
  LightSample SampleIncident(Vec3 p, Vec2 u) const override;
  float PdfIncident(Vec3 p, const SurfacePoint& seen, Vec3 w) const override;
  Spectrum Emitted(const SurfacePoint& point, Vec3 w) const override;
  LightReach Reach() const override;
  EmissionSample SampleEmission(const Ball& scene, Vec2 u_position,
                                Vec2 u_direction) const override;
  EmissionPdf PdfEmission(const Ball& scene, const SurfacePoint& from, Vec3 w) const override;
  float Power(const Ball& scene) const override;
  bool IsFoundByHitsAlone() const override { return !sampler_ && MeanOf(radiance_.ToRgb()) > 0; }
  void SetSurface(std::unique_ptr<const SurfaceSampler> sampler, Vec3 center,
                  float radius) override;

 private:
  /// What leaves in the direction `w` where the normal is `n`.
  Spectrum EmittedTo(Vec3 w, Vec3 n) const;
  float Sides() const { return is_two_sided_ ? 2 : 1; }

  Spectrum radiance_;
  bool is_two_sided_;
  std::unique_ptr<const SurfaceSampler> sampler_;
  Vec3 center_;
  float radius_ = 0;
};

}  // namespace candela
