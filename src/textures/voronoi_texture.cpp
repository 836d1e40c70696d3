#include "textures/voronoi_texture.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include "textures/cell_noise.h"
#include "textures/fractal_noise.h"

namespace candela {
namespace {

constexpr std::string_view kFeatures[] = {"distance", "edges", "cells"};

}  // namespace

VoronoiTexture::VoronoiTexture(Feature feature, float jitter, ColorRange colors,
                               const SolidPlace& place)
    : feature_(feature), jitter_(jitter), mean_(0), colors_(std::move(colors)), place_(place) {
  // Over points that fill a cube evenly: M. Roberts, "The Unreasonable Effectiveness of
  // Quasirandom Sequences", 2018.
  constexpr int kPoints = 4096;
  constexpr float kSide = 16;
  double sum = 0;
  for (int i = 0; i < kPoints; ++i) {
    const auto part = [i](double ratio) {
      const double x = 0.5 + ratio * i;
      return kSide * static_cast<float>(x - std::floor(x));
    };
    const Vec3 p{part(0.8191725133961645), part(0.6710436067037893), part(0.5497004779019703)};
    sum += static_cast<double>(ValueAt(p));
  }
  mean_ = static_cast<float>(sum / kPoints);
}

std::shared_ptr<const Texture> VoronoiTexture::Create(ParamReader* params,
                                                      const TextureContext& context) {
  ColorRange colors = ColorRange::Create(params, context);
  const auto feature = static_cast<Feature>(params->Choice("feature", kFeatures, 0));
  const float jitter = params->Fraction("jitter", 1);
  return std::make_shared<VoronoiTexture>(feature, jitter, std::move(colors),
                                          SolidPlace::Create(params));
}

float VoronoiTexture::ValueAt(Vec3 p) const {
  const CellPoints points = NearestCellPoints(p, jitter_);
  switch (feature_) {
    case Feature::kDistance:
      return std::min(points.nearest, 1.0f);
    case Feature::kEdges:
      return std::min(points.second - points.nearest, 1.0f);
    case Feature::kCells:
      break;
  }
  return static_cast<float>(points.cell >> 8) * 0x1p-24f;
}

Rgb VoronoiTexture::Lookup(const SurfacePoint& point) const {
  const auto [p, size] = place_.At(point);
  const float detail = DetailLeft(point.footprint * size);
  const float value = detail > 0 ? ValueAt(p) * detail + mean_ * (1 - detail) : mean_;
  return colors_.At(value, point);
}

}  // namespace candela
