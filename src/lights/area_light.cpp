#include "lights/area_light.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "lights/light_context.h"
#include "lights/temperature.h"
#include "math/elementary.h"
#include "math/frame.h"
#include "sampling/warp.h"

namespace candela {

std::unique_ptr<Light> AreaLight::Create(ParamReader* params, const LightContext& context) {
  const Rgb tint = params->NonNegativeColor("radiance", {1, 1, 1});
  const Rgb radiance = ByTemperature(params, tint);
  const bool is_two_sided = params->Flag("two_sided", true);
  if (!context.has_object) {
    params->Error(params->Where("type"),
                  "an area light needs an object in its node, to shine from");
  }
  return std::make_unique<AreaLight>(Spectrum(radiance), is_two_sided);
}

void AreaLight::SetSurface(std::unique_ptr<const SurfaceSampler> sampler, Vec3 center,
                           float radius) {
  sampler_ = std::move(sampler);
  center_ = center;
  radius_ = radius;
}

LightSample AreaLight::SampleIncident(Vec3 p, Vec2 u) const {
  if (!sampler_) return {{}, {}, 0, 0};
  const SurfaceSample sample = sampler_->Sample(p, u);
  if (sample.pdf == 0) return {{}, {}, 0, 0};
  return {sample.direction, EmittedTo(-sample.direction, sample.n), sample.distance, sample.pdf};
}

float AreaLight::PdfIncident(Vec3 p, const SurfacePoint& seen, Vec3) const {
  return sampler_ ? sampler_->Pdf(p, seen.p, seen.n_geometric) : 0;
}

Spectrum AreaLight::Emitted(const SurfacePoint& point, Vec3 w) const {
  // `whitted` knows the shading normal only.
  return EmittedTo(w, point.n_geometric == Vec3() ? point.n_shading : point.n_geometric);
}

Spectrum AreaLight::EmittedTo(Vec3 w, Vec3 n) const {
  return is_two_sided_ || Dot(n, w) > 0 ? radiance_ : Spectrum();
}

LightReach AreaLight::Reach() const {
  if (!sampler_) return {};
  LightReach reach{Power({}), false, center_, radius_};
  reach.axis = sampler_->FlatNormal();
  if (reach.axis == Vec3()) return reach;
  reach.is_flat = true;
  // Along its normal a flat lamp gives so much more than one that shines all around alike.
  reach.power *= is_two_sided_ ? 2 : 4;
  if (!is_two_sided_) reach.least_cosine = 0;
  return reach;
}

EmissionSample AreaLight::SampleEmission(const Ball&, Vec2 u_position, Vec2 u_direction) const {
  if (!sampler_) return {};
  const AreaSample drawn = sampler_->SampleArea(u_position);
  Vec3 n = drawn.point.n_geometric;
  if (is_two_sided_) {
    u_direction.x *= 2;
    if (u_direction.x >= 1) {
      u_direction.x -= 1;
      n = -n;
    }
  }
  const Vec3 local = SampleCosineHemisphere(u_direction);
  if (!(local.z > 0) || !(drawn.pdf > 0)) return {};
  EmissionSample sample;
  sample.origin = drawn.point;
  sample.direction = Frame::FromNormal(n).ToWorld(local);
  sample.pdf_position = drawn.pdf;
  sample.pdf_direction = CosineHemispherePdf(local.z) / Sides();
  // The cosine cancels that of the density.
  sample.flux = radiance_ * (static_cast<float>(kPi) * Sides() / drawn.pdf);
  return sample;
}

EmissionPdf AreaLight::PdfEmission(const Ball&, const SurfacePoint& from, Vec3 w) const {
  if (!sampler_) return {0, 0};
  const float cosine = Dot(from.n_geometric, w);
  const float density = CosineHemispherePdf(is_two_sided_ ? std::abs(cosine) : cosine);
  return {sampler_->PdfArea(from.n_geometric), density / Sides()};
}

float AreaLight::Power(const Ball&) const {
  if (!sampler_) return 0;
  const double flux = kPi * sampler_->Area() * double{Sides()} * double{MeanOf(radiance_.ToRgb())};
  // The largest lamps keep an order among each other.
  return static_cast<float>(std::min(flux, 1e30));
}

}  // namespace candela
