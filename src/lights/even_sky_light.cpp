#include "lights/even_sky_light.h"

#include "lights/sky_emission.h"
#include "math/elementary.h"
#include "sampling/warp.h"

namespace candela {

LightSample EvenSkyLight::SampleIncident(Vec3, Vec2 u) const {
  return {SampleUniformSphere(u), radiance_, std::numeric_limits<float>::max(), UniformSpherePdf()};
}

float EvenSkyLight::PdfIncident(Vec3, const SurfacePoint&, Vec3) const {
  return UniformSpherePdf();
}

LightReach EvenSkyLight::Reach() const {
  return {static_cast<float>(kPi) * MeanOf(Abs(radiance_.ToRgb())), true, {}, 0};
}

EmissionSample EvenSkyLight::SampleEmission(const Ball& scene, Vec2 u_position,
                                            Vec2 u_direction) const {
  return EmitFromSky(scene, SampleUniformSphere(u_direction), UniformSpherePdf(), radiance_,
                     u_position);
}

EmissionPdf EvenSkyLight::PdfEmission(const Ball& scene, const SurfacePoint&, Vec3) const {
  return {SkyPositionPdf(scene), UniformSpherePdf()};
}

float EvenSkyLight::Power(const Ball& scene) const {
  return MeanOf(Abs(radiance_.ToRgb())) / UniformSpherePdf() *
         static_cast<float>(SkyDiskArea(scene));
}

}  // namespace candela
