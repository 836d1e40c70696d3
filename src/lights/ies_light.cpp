#include "lights/ies_light.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "lights/light_context.h"
#include "lights/temperature.h"
#include "lights/way_to_light.h"
#include "math/elementary.h"

namespace candela {
namespace {

/// Where a lamp in a node points: down is -y, the horizontal angle of 0 at +x, that of 90 at -z.
/// Nothing where the transform leaves no such directions.
std::optional<Frame> FrameIn(const Transform& world_from_node) {
  const Vec3 down = world_from_node.Vector({0, -1, 0}), first = world_from_node.Vector({1, 0, 0});
  const Vec3d z = Normalize(ToDouble(down));
  const Vec3d across = Cross(z, Normalize(ToDouble(first)));
  if (!(Length(across) >= 1e-6)) return std::nullopt;  // Of what is not finite too.
  Frame frame;
  frame.z = ToFloat(z);
  frame.y = ToFloat(Normalize(across));
  frame.x = Cross(frame.y, frame.z);
  // A mirrored node mirrors the lamp.
  if (Dot(frame.y, world_from_node.Vector({0, 0, -1})) < 0) frame.y = -frame.y;
  return frame;
}

}  // namespace

IesLight::IesLight(Vec3 position, const Frame& frame, std::shared_ptr<const IesProfile> profile,
                   Rgb color)
    : position_(position), frame_(frame), profile_(std::move(profile)), color_(color) {}

std::unique_ptr<Light> IesLight::Create(ParamReader* params, const LightContext& context) {
  const ParamWord file = params->RequiredPath("file");
  const Rgb tint = params->Color("color", {1, 1, 1});
  const Rgb color = ByTemperature(params, tint);
  const float scale = params->NonNegative("scale", 0.001f);
  if (file.text.empty()) return nullptr;
  const std::shared_ptr<const IesFile> lamp =
      ReadIesFile(context.textures->find_file(file), file.where, context.ies_files,
                  context.textures->diagnostics);
  const std::optional<Frame> frame = FrameIn(context.world_from_node);
  if (!frame) {
    params->Error(params->Where("file"),
                  "the transform of the node leaves the lamp no direction to point to");
  }
  if (!lamp || !frame) return nullptr;
  const double tilt = Atan2(
      std::sqrt(double{frame->z.x} * double{frame->z.x} + double{frame->z.z} * double{frame->z.z}),
      double{-frame->z.y});
  const float brightness = scale * lamp->TiltFactor(tilt * (180 / kPi));
  return std::make_unique<IesLight>(context.world_from_node.Point({0, 0, 0}), *frame,
                                    std::shared_ptr<const IesProfile>(lamp, &lamp->profile),
                                    color * brightness);
}

LightSample IesLight::SampleIncident(Vec3 p) const {
  const WayToLight way(p, position_);
  if (way.IsNone()) return {};
  const Vec3 direction = way.Direction();
  const float intensity = profile_->Intensity(frame_.ToLocal(-direction));
  return {direction, Spectrum(color_ * (intensity / way.squared)), way.distance};
}

// The mean of the intensity over the cone that it shines into, as if it was so all around.
LightReach IesLight::Reach() const {
  constexpr auto kAllAround = static_cast<float>(4 * kPi);
  const float height = profile_->MostCosine() - profile_->LeastCosine();
  const float mean = static_cast<float>(profile_->Flux() / (2 * kPi)) / height;
  LightReach reach{kAllAround * mean * MeanOf(Abs(color_)), false, position_, 0};
  if (profile_->MostCosine() < 1) {
    reach.axis = -frame_.z;
    reach.least_cosine = -profile_->MostCosine();
  } else if (profile_->LeastCosine() > -1) {
    reach.axis = frame_.z;
    reach.least_cosine = profile_->LeastCosine();
  }
  return reach;
}

EmissionSample IesLight::SampleEmission(const Ball&, Vec2, Vec2 u_direction) const {
  const IesProfile::Sample drawn = profile_->Draw(u_direction);
  EmissionSample sample;
  sample.origin.p = position_;
  sample.direction = frame_.ToWorld(drawn.w);
  sample.flux = Spectrum(color_ * (profile_->Intensity(drawn.w) / drawn.pdf));
  sample.pdf_position = 1;
  sample.pdf_direction = drawn.pdf;
  return sample;
}

EmissionPdf IesLight::PdfEmission(const Ball&, const SurfacePoint&, Vec3 w) const {
  return {1, profile_->Pdf(frame_.ToLocal(w))};
}

float IesLight::Power(const Ball&) const {
  return MeanOf(Abs(color_)) * static_cast<float>(profile_->Flux());
}

}  // namespace candela
