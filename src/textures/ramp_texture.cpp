#include "textures/ramp_texture.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

namespace candela {
namespace {

constexpr std::string_view kBlends[] = {"linear", "smooth", "step"};
constexpr std::string_view kWraps[] = {"clamp", "repeat", "mirror"};
constexpr std::string_view kAxes[] = {"x", "y", "z"};

std::vector<RampTexture::Stop> ReadStops(ParamReader* params) {
  const std::vector<float> numbers = params->RequiredNumberGroups(
      "stops", 4, "four numbers for each stop, its place and its colour");
  std::vector<RampTexture::Stop> stops;
  for (size_t i = 0; i < numbers.size(); i += 4) {
    const RampTexture::Stop stop{numbers[i], {numbers[i + 1], numbers[i + 2], numbers[i + 3]}};
    if (!stops.empty() && stop.at < stops.back().at) {
      params->Error(params->Where("stops"), "the stops of a ramp stand in ascending order");
      break;
    }
    stops.push_back(stop);
  }
  return stops;
}

float Wrapped(float t, RampTexture::Wrap wrap) {
  switch (wrap) {
    case RampTexture::Wrap::kClamp:
      return t;
    case RampTexture::Wrap::kRepeat:
      return t - std::floor(t);
    case RampTexture::Wrap::kMirror: {
      const float pairs = t / 2 - std::floor(t / 2);  // From 0 to 1 over both ways.
      return 1 - std::abs(2 * pairs - 1);
    }
  }
  return t;
}

}  // namespace

std::shared_ptr<const Texture> RampTexture::Create(ParamReader* params,
                                                   const TextureContext& context) {
  std::vector<Stop> stops = ReadStops(params);
  const auto blend = static_cast<Blend>(params->Choice("blend", kBlends, 0));
  std::shared_ptr<const Texture> input = TextureParam(params, "input", context);
  Along along{{}, 0, Wrap::kClamp};
  if (params->Has("input")) {
    if (params->Has("along")) {
      params->Error(params->Where("along"),
                    "the place on a ramp is given by 'input' or by 'along', not by both");
    }
  } else {
    along.axis = static_cast<int>(params->Choice("along", kAxes, 0));
    along.wrap = static_cast<Wrap>(params->Choice("wrap", kWraps, 0));
    along.place = SolidPlace::Create(params);
  }
  if (stops.empty()) return nullptr;
  return std::make_shared<RampTexture>(std::move(stops), blend, NumberInput(std::move(input)),
                                       along);
}

float RampTexture::PositionOf(const SurfacePoint& point) const {
  if (input_.IsTextured()) return input_.At(point);
  return Wrapped(along_.place.At(point).p[along_.axis], along_.wrap);
}

Rgb RampTexture::Lookup(const SurfacePoint& point) const {
  const float t = PositionOf(point);
  const auto after = std::upper_bound(stops_.begin(), stops_.end(), t,
                                      [](float at, const Stop& stop) { return at < stop.at; });
  if (after == stops_.begin()) return stops_.front().color;
  const Stop& before = *(after - 1);
  if (after == stops_.end() || blend_ == Blend::kStep) return before.color;
  float part = (t - before.at) / (after->at - before.at);
  if (blend_ == Blend::kSmooth) part = part * part * (3 - 2 * part);
  return before.color * (1 - part) + after->color * part;
}

}  // namespace candela
