#include "lights/spot_light.h"

#include <algorithm>
#include <cmath>

#include "lights/light_context.h"
#include "lights/temperature.h"
#include "lights/way_to_light.h"
#include "math/elementary.h"
#include "math/frame.h"
#include "sampling/warp.h"

namespace candela {

SpotLight::SpotLight(Vec3 position, const Beam& beam, Rgb color, Falloff falloff)
    : position_(position),
      direction_(NormalizeAnyLength(beam.direction)),
      cosine_inner_(beam.cosine_inner),
      cosine_outer_(beam.cosine_outer),
      color_(color),
      falloff_(falloff) {}

std::unique_ptr<Light> SpotLight::Create(ParamReader* params, const LightContext& context) {
  const Vec3 direction = params->RequiredDirection("direction");
  const float angle = params->RequiredAngle("angle");
  const float blend = params->Fraction("blend", 0.15f);
  const Rgb tint = params->Color("color", {1, 1, 1});
  const Rgb color = ByTemperature(params, tint);
  const Falloff falloff = Falloff::Read(params);
  Vec3 in_world = context.world_from_node.Vector(direction);
  if (in_world == Vec3() || !IsFinite(in_world)) {
    if (params->Has("direction")) {
      params->Error(params->Where("direction"),
                    "the transform of the node leaves the spot no direction");
    }
    in_world = direction;
  }
  const Beam beam{in_world, static_cast<float>(CosDegrees(double{angle} / 2 * (1 - double{blend}))),
                  static_cast<float>(CosDegrees(double{angle} / 2))};
  return std::make_unique<SpotLight>(context.world_from_node.Point({0, 0, 0}), beam, color,
                                     falloff);
}

float SpotLight::Brightness(float cosine) const {
  if (cosine >= cosine_inner_) return 1;
  if (!(cosine > cosine_outer_)) return 0;
  const float x = (cosine - cosine_outer_) / (cosine_inner_ - cosine_outer_);
  return x * x * (3 - 2 * x);  // Level at both ends.
}

LightSample SpotLight::SampleIncident(Vec3 p) const {
  const WayToLight way(p, position_);
  if (way.IsNone()) return {};
  const Vec3 direction = way.Direction();
  const Rgb radiance =
      color_ * (Brightness(-Dot(direction, direction_)) / falloff_.At(way.distance, way.squared));
  return {direction, Spectrum(radiance), way.distance};
}

LightReach SpotLight::Reach() const {
  // Its power is that of a light all around: whoever is in its beam sees no less.
  constexpr auto kAllAround = static_cast<float>(4 * kPi);
  LightReach reach{kAllAround * MeanOf(Abs(color_)) / falloff_.ForComparison(), false, position_,
                   0};
  reach.axis = direction_;
  reach.least_cosine = cosine_outer_;
  return reach;
}

// Directions are drawn evenly from the cone; what a narrow one rounds to nothing sends no light.
EmissionSample SpotLight::SampleEmission(const Ball&, Vec2, Vec2 u_direction) const {
  if (!CanBeSentOut()) return {};
  const float one_minus_cosine = 1 - cosine_outer_;
  const Vec3 local = SampleCone(u_direction, one_minus_cosine);
  EmissionSample sample;
  sample.origin.p = position_;
  sample.direction = Frame::FromNormal(direction_).ToWorld(local);
  sample.pdf_position = 1;
  sample.pdf_direction = ConePdf(one_minus_cosine);
  sample.flux =
      Spectrum(color_ * (Brightness(local.z) / falloff_.quadratic)) * (1 / sample.pdf_direction);
  return sample;
}

EmissionPdf SpotLight::PdfEmission(const Ball&, const SurfacePoint&, Vec3 w) const {
  return {1, Dot(w, direction_) >= cosine_outer_ ? ConePdf(1 - cosine_outer_) : 0};
}

// The falloff is symmetric about the middle of its two cosines.
float SpotLight::Power(const Ball&) const {
  if (!CanBeSentOut()) return 0;
  const float mean_cosine = (cosine_inner_ + cosine_outer_) / 2;
  return MeanOf(Abs(color_)) / falloff_.quadratic * static_cast<float>(2 * kPi) * (1 - mean_cosine);
}

}  // namespace candela
