#include "lights/projector_light.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "lights/light_context.h"
#include "lights/temperature.h"
#include "lights/way_to_light.h"
#include "math/elementary.h"

namespace candela {
namespace {

/// Cells of the grid by which directions of emission are drawn, on each side; each is looked at in
/// four points.
constexpr int kGrid = 256;

/// The share of emission that is drawn from the whole picture, for what the grid does not see.
constexpr float kEvenShare = 0.1f;

/// What falls through the grid keeps a little of the choice among lights.
constexpr float kLeastMean = 1e-3f;

SurfacePoint PointAt(Vec2 uv) {
  SurfacePoint point;
  point.uv = uv;
  point.p = {uv.x, uv.y, 0};
  return point;
}

Rgb Lookup(const ColorInput& image, Vec2 uv) {
  return Max(image.At(PointAt(uv)), Rgb());
}

/// The means of cells over the colours, rows from v = 0 upwards, and over all of them the mean.
struct Means {
  std::vector<float> cells;
  Rgb all;
};

Means MeansOfCells(const ColorInput& image) {
  Means means;
  means.cells.reserve(size_t{kGrid} * kGrid);
  Vec3d sum;
  for (int row = 0; row < kGrid; ++row) {
    for (int column = 0; column < kGrid; ++column) {
      Rgb cell;
      for (const float dv : {0.25f, 0.75f}) {
        for (const float du : {0.25f, 0.75f}) {
          cell += Lookup(image, {(static_cast<float>(column) + du) / kGrid,
                                 (static_cast<float>(row) + dv) / kGrid});
        }
      }
      means.cells.push_back(MeanOf(cell) / 4);
      sum = sum + ToDouble(cell);
    }
  }
  means.all = ToFloat(sum * (1.0 / (4.0 * kGrid * kGrid)));
  return means;
}

}  // namespace

ProjectorLight::ProjectorLight(Vec3 position, const Beam& beam, ColorInput image, Rgb color,
                               float attenuation)
    : position_(position),
      extent_(beam.extent),
      image_(std::move(image)),
      intensity_(color / attenuation) {
  frame_.z = NormalizeAnyLength(beam.direction);
  frame_.x = NormalizeAnyLength(Cross(frame_.z, NormalizeAnyLength(beam.up)));
  frame_.y = Cross(frame_.x, frame_.z);
  if (beam.is_mirrored) frame_.x = -frame_.x;
}

const ProjectorLight::Overview& ProjectorLight::TheOverview() const {
  std::call_once(is_looked_at_, [this] {
    if (image_.IsTextured()) {
      const Means means = MeansOfCells(image_);
      overview_.reset(new Overview{means.all, Distribution2D(means.cells, kGrid)});
      return;
    }
    const Rgb color = Max(image_.value(), Rgb());
    const float cell[] = {MeanOf(color)};
    overview_.reset(new Overview{color, Distribution2D(cell, 1)});
  });
  return *overview_;
}

std::unique_ptr<Light> ProjectorLight::Create(ParamReader* params, const LightContext& context) {
  const Diagnostics& diagnostics = *context.textures->diagnostics;
  const size_t errors_before = diagnostics.ErrorCount();
  ColorInput image = ColorInput::Color(params, "image", {1, 1, 1}, *context.textures);
  const Vec3 direction = params->RequiredDirection("direction");
  const Vec3 up = params->RequiredDirection("up");
  const float fov = params->RequiredAngle("fov");
  const float aspect = params->Positive("aspect", 1);
  const Rgb tint = params->Color("color", {1, 1, 1});
  const Rgb color = ByTemperature(params, tint);
  const float attenuation = params->Positive("attenuation", 20);

  const auto are_parallel = [](Vec3 a, Vec3 b) {
    const Vec3d across = Cross(Normalize(ToDouble(a)), Normalize(ToDouble(b)));
    return !(Length(across) >= 1e-6);  // Of what is not finite too.
  };
  Beam beam{context.world_from_node.Vector(direction), context.world_from_node.Vector(up), {1, 1}};
  const Vec3 right = context.world_from_node.Vector(Cross(direction, up));
  beam.is_mirrored = Dot(right, Cross(beam.direction, beam.up)) < 0;
  const bool are_right =
      params->Has("direction") && params->Has("up") && diagnostics.ErrorCount() == errors_before;
  if (are_right && are_parallel(direction, up)) {
    params->Error(params->Where("up"), "'up' is parallel to 'direction'");
  } else if (are_right && are_parallel(beam.direction, beam.up)) {
    params->Error(params->Where("direction"),
                  "the transform of the node leaves the projector no direction, or no 'up'");
  }
  if (are_parallel(beam.direction, beam.up)) beam = {{0, 0, -1}, {0, 1, 0}, {1, 1}};
  const auto half_height = static_cast<float>(TanDegrees(double{fov} / 2));
  beam.extent = {half_height * aspect, half_height};
  if (!(beam.extent.x > 0) || !std::isfinite(beam.extent.x * beam.extent.y)) {
    params->Error(params->Where("aspect"), "the picture is too wide or too narrow");
    beam.extent = {1, 1};
  }
  return std::make_unique<ProjectorLight>(context.world_from_node.Point({0, 0, 0}), beam,
                                          std::move(image), color, attenuation);
}

ProjectorLight::Place ProjectorLight::PlaceOf(Vec3 direction) const {
  const Vec3 w = frame_.ToLocal(direction);
  if (!(w.z > 0)) return {{}, 0};
  const Vec2 uv{0.5f + 0.5f * w.x / (w.z * extent_.x), 0.5f + 0.5f * w.y / (w.z * extent_.y)};
  const bool is_inside = uv.x >= 0 && uv.x <= 1 && uv.y >= 0 && uv.y <= 1;
  return {uv, is_inside ? w.z : 0};
}

Rgb ProjectorLight::ImageAt(Vec2 uv) const {
  return Lookup(image_, uv);
}

float ProjectorLight::PdfOfPlace(Vec2 uv) const {
  constexpr float kBelowOne = 0x1.fffffep-1f;
  const Vec2 inside{std::min(uv.x, kBelowOne), std::min(uv.y, kBelowOne)};
  return kEvenShare + (1 - kEvenShare) * TheOverview().distribution.Pdf(inside);
}

LightSample ProjectorLight::SampleIncident(Vec3 p) const {
  const WayToLight way(p, position_);
  if (way.IsNone()) return {};
  const Vec3 direction = way.Direction();
  const Place place = PlaceOf(-direction);
  if (place.cosine == 0) return {direction, {}, way.distance};
  const float cube = place.cosine * place.cosine * place.cosine;
  const Rgb radiance = intensity_ * ImageAt(place.uv) / (cube * way.squared);
  return {direction, Spectrum(radiance), way.distance};
}

LightReach ProjectorLight::Reach() const {
  constexpr auto kAllAround = static_cast<float>(4 * kPi);
  const float mean = std::max(MeanOf(TheOverview().mean), kLeastMean) * MeanOf(Abs(intensity_));
  LightReach reach{kAllAround * mean, false, position_, 0};
  reach.axis = frame_.z;
  const float corner = extent_.x * extent_.x + extent_.y * extent_.y;
  reach.least_cosine = 1 / std::sqrt(1 + corner);
  return reach;
}

// Places in the picture are drawn; over solid angle their density grows by the cube of the cosine
// that the intensity has too, so the flux does not depend on it.
EmissionSample ProjectorLight::SampleEmission(const Ball&, Vec2, Vec2 u_direction) const {
  Vec2 uv;
  if (u_direction.x < kEvenShare) {
    uv = {u_direction.x / kEvenShare, u_direction.y};
  } else {
    const float rest = (u_direction.x - kEvenShare) / (1 - kEvenShare);
    uv = TheOverview().distribution.Draw({std::min(rest, 0x1.fffffep-1f), u_direction.y}).position;
  }
  const Vec3 local{(2 * uv.x - 1) * extent_.x, (2 * uv.y - 1) * extent_.y, 1};
  const float squared = LengthSquared(local);
  const float length = std::sqrt(squared);
  const float pdf = PdfOfPlace(uv) / Area();
  EmissionSample sample;
  sample.origin.p = position_;
  sample.direction = frame_.ToWorld(local / length);
  sample.flux = Spectrum(intensity_ * ImageAt(uv) / pdf);
  sample.pdf_position = 1;
  sample.pdf_direction = pdf * squared * length;
  return sample;
}

EmissionPdf ProjectorLight::PdfEmission(const Ball&, const SurfacePoint&, Vec3 w) const {
  const Place place = PlaceOf(w);
  if (place.cosine == 0) return {1, 0};
  const float cube = place.cosine * place.cosine * place.cosine;
  return {1, PdfOfPlace(place.uv) / (Area() * cube)};
}

float ProjectorLight::Power(const Ball&) const {
  const Rgb color =
      Max(TheOverview().mean, Rgb{kLeastMean, kLeastMean, kLeastMean}) * Abs(intensity_);
  return MeanOf(color) * Area();
}

}  // namespace candela
