#include "lights/point_light.h"

#include <algorithm>
#include <cmath>

#include "lights/light_context.h"
#include "lights/temperature.h"
#include "lights/way_to_light.h"
#include "math/elementary.h"
#include "sampling/warp.h"

namespace candela {

std::unique_ptr<Light> PointLight::Create(ParamReader* params, const LightContext& context) {
  const Rgb tint = params->Color("color", {1, 1, 1});
  const Rgb color = ByTemperature(params, tint);
  const Falloff falloff = Falloff::Read(params);
  params->Vector("direction", {0, 0, -1});  // The course's format allows it here, without effect.
  return std::make_unique<PointLight>(context.world_from_node.Point({0, 0, 0}), color, falloff);
}

LightSample PointLight::SampleIncident(Vec3 p) const {
  const WayToLight way(p, position_);
  if (way.IsNone()) return {};
  const Rgb radiance = color_ / falloff_.At(way.distance, way.squared);
  return {way.Direction(), Spectrum(radiance), way.distance};
}

LightReach PointLight::Reach() const {
  constexpr auto kAllAround = static_cast<float>(4 * kPi);
  return {kAllAround * MeanOf(Abs(color_)) / falloff_.ForComparison(), false, position_, 0};
}

EmissionSample PointLight::SampleEmission(const Ball&, Vec2, Vec2 u_direction) const {
  if (!CanBeSentOut()) return {};
  EmissionSample sample;
  sample.origin.p = position_;
  sample.direction = SampleUniformSphere(u_direction);
  sample.flux = Spectrum(color_ / falloff_.quadratic) * (1 / UniformSpherePdf());
  sample.pdf_position = 1;
  sample.pdf_direction = UniformSpherePdf();
  return sample;
}

EmissionPdf PointLight::PdfEmission(const Ball&, const SurfacePoint&, Vec3) const {
  return {1, UniformSpherePdf()};
}

float PointLight::Power(const Ball&) const {
  if (!CanBeSentOut()) return 0;
  return MeanOf(Abs(color_)) / falloff_.quadratic / UniformSpherePdf();
}

}  // namespace candela
