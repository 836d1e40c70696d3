#include "lights/directional_light.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "lights/sky_emission.h"
#include "lights/temperature.h"
#include "math/elementary.h"
#include "math/frame.h"
#include "sampling/warp.h"

namespace candela {

DirectionalLight::DirectionalLight(Vec3 direction, Rgb color, float angle_degrees)
    : to_light_(-NormalizeAnyLength(direction)), color_(color) {
  // 1 - cos a = 2 sin^2(a / 2), which small angles do not cancel.
  const double quarter = SinDegrees(double{angle_degrees} / 4);
  one_minus_cosine_ = static_cast<float>(2 * quarter * quarter);
  if (one_minus_cosine_ == 0) return;
  // The irradiance of a disk in the sky is pi sin^2 times its radiance.
  const double half = SinDegrees(double{angle_degrees} / 2);
  radiance_ = color / static_cast<float>(kPi * half * half);
}

std::unique_ptr<Light> DirectionalLight::Create(ParamReader* params, const LightContext&) {
  const Vec3 direction = params->RequiredDirection("direction");
  const Rgb tint = params->Color("color", {1, 1, 1});
  const Rgb color = ByTemperature(params, tint);
  params->Positive("attenuation", 20);  // The course's format allows it here, without effect.
  const float angle = params->NonNegative("angle", 0);
  if (angle >= 180) {
    params->Error(
        params->Where("angle"),
        fmt::format("'angle' expects an angle from 0 to below 180 degrees, found '{}'", angle));
    return std::make_unique<DirectionalLight>(direction, color);
  }
  return std::make_unique<DirectionalLight>(direction, color, angle);
}

LightSample DirectionalLight::SampleIncident(Vec3 p, Vec2 u) const {
  if (one_minus_cosine_ == 0) return SampleIncident(p);
  const Vec3 w = Frame::FromNormal(to_light_).ToWorld(SampleCone(u, one_minus_cosine_));
  return {w, Spectrum(radiance_), std::numeric_limits<float>::max(), ConePdf(one_minus_cosine_)};
}

bool DirectionalLight::IsSeenAlong(Vec3 w) const {
  // |w - axis|^2 = 2 (1 - cosine) keeps the digits that a dot product of near directions loses.
  return LengthSquared(w - to_light_) <= 2 * one_minus_cosine_;
}

float DirectionalLight::PdfIncident(Vec3, const SurfacePoint&, Vec3 w) const {
  return one_minus_cosine_ > 0 && IsSeenAlong(w) ? ConePdf(one_minus_cosine_) : 0;
}

Spectrum DirectionalLight::Emitted(const SurfacePoint&, Vec3 w) const {
  return one_minus_cosine_ > 0 && IsSeenAlong(-w) ? Spectrum(radiance_) : Spectrum();
}

LightReach DirectionalLight::Reach() const {
  return {MeanOf(Abs(color_)), true, {}, 0};
}

EmissionSample DirectionalLight::SampleEmission(const Ball& scene, Vec2 u_position,
                                                Vec2 u_direction) const {
  const LightSample seen = SampleIncident({}, u_direction);
  return EmitFromSky(scene, -seen.direction, seen.pdf, seen.radiance, u_position);
}

EmissionPdf DirectionalLight::PdfEmission(const Ball& scene, const SurfacePoint&, Vec3 w) const {
  return {SkyPositionPdf(scene), one_minus_cosine_ > 0 ? PdfIncident({}, {}, -w) : 1};
}

float DirectionalLight::Power(const Ball& scene) const {
  const float across = one_minus_cosine_ > 0 ? MeanOf(Abs(radiance_)) / ConePdf(one_minus_cosine_)
                                             : MeanOf(Abs(color_));
  return across * static_cast<float>(SkyDiskArea(scene));
}

}  // namespace candela
