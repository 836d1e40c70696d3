#include "lights/environment_light.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "lights/sky_emission.h"
#include "math/elementary.h"
#include "sampling/warp.h"
#include "textures/lat_long.h"

namespace candela {
namespace {

// Fine enough for windows and lamps in a picture; built in a few hundredths of a second.
constexpr size_t kGridColumns = 256;
constexpr size_t kGridRows = 128;

/// The mean over each cell of a grid, from the middles of its quarters.
std::vector<float> MeansOfCells(const CubeMap& map) {
  std::vector<float> means;
  means.reserve(kGridColumns * kGridRows);
  for (size_t row = 0; row < kGridRows; ++row) {
    for (size_t column = 0; column < kGridColumns; ++column) {
      float sum = 0;
      for (const float dy : {0.25f, 0.75f}) {
        for (const float dx : {0.25f, 0.75f}) {
          const Vec2 place{(static_cast<float>(column) + dx) / kGridColumns,
                           (static_cast<float>(row) + dy) / kGridRows};
          sum += MeanOf(map.Lookup(DirectionOfLatLong(place)));
        }
      }
      means.push_back(sum / 4);
    }
  }
  return means;
}

}  // namespace

EnvironmentLight::EnvironmentLight(const EnvironmentMap& map)
    : map_(&map), turn_(map.Turn()), distribution_([&] {
        std::vector<float> means = map.MeansOfCells();
        return Distribution2D(WeighBySolidAngle(means, map.Columns()), map.Columns());
      }()) {}

EnvironmentLight::EnvironmentLight(const CubeMap& map)
    : cube_map_(&map), distribution_([&] {
        std::vector<float> means = MeansOfCells(map);
        return Distribution2D(WeighBySolidAngle(means, kGridColumns), kGridColumns);
      }()) {}

std::span<const float> EnvironmentLight::WeighBySolidAngle(std::span<float> means, size_t columns) {
  const size_t rows = means.size() / columns;
  double sum = 0;
  double above = 1;  // The cosine at the upper edge of the row.
  for (size_t row = 0; row < rows; ++row) {
    const double below = Cos(kPi * static_cast<double>(row + 1) / static_cast<double>(rows));
    const auto weight = static_cast<float>((above - below) / 2);  // Of the sphere.
    for (float& mean : means.subspan(row * columns, columns)) {
      mean *= weight;
      sum += mean;
    }
    above = below;
  }
  irradiance_ = static_cast<float>(kPi * sum / static_cast<double>(columns));
  return means;
}

Spectrum EnvironmentLight::Radiance(Vec3 direction) const {
  return Spectrum(map_ ? map_->Lookup(direction) : cube_map_->Lookup(direction));
}

// The square of longitude and latitude is mapped to the sphere with 2 pi^2 sine per unit of area.
LightSample EnvironmentLight::SampleIncident(Vec3, Vec2 u) const {
  const Distribution2D::Sample sample = distribution_.Draw(u);
  const Vec3 w = DirectionOfLatLong(TurnLatLong(sample.position, -turn_));
  const float sine = Sin(sample.position.y * static_cast<float>(kPi));
  if (!(sine > 0)) return {{}, {}, 0, 0};
  const float pdf = sample.pdf / (static_cast<float>(2 * kPi * kPi) * sine);
  return {w, Radiance(w), std::numeric_limits<float>::max(), pdf};
}

float EnvironmentLight::PdfIncident(Vec3, const SurfacePoint&, Vec3 w) const {
  const float sine = std::sqrt(std::max(0.0f, w.x * w.x + w.z * w.z));
  if (!(sine > 0)) return 0;
  const Vec2 place = TurnLatLong(LatLongOf(w), turn_);
  return distribution_.Pdf(place) / (static_cast<float>(2 * kPi * kPi) * sine);
}

EmissionSample EnvironmentLight::SampleEmission(const Ball& scene, Vec2 u_position,
                                                Vec2 u_direction) const {
  const float even = EvenShare();
  Vec3 to_sky;
  if (u_direction.x < even) {
    to_sky = SampleUniformSphere({u_direction.x / even, u_direction.y});
  } else {
    u_direction.x = std::min((u_direction.x - even) / (1 - even), 0x1.fffffep-1f);
    const LightSample seen = SampleIncident({}, u_direction);
    if (seen.pdf == 0) return {};
    to_sky = seen.direction;
  }
  const float pdf = PdfEmission(scene, {}, -to_sky).direction;
  if (!(pdf > 0)) return {};
  return EmitFromSky(scene, -to_sky, pdf, Radiance(to_sky), u_position);
}

EmissionPdf EnvironmentLight::PdfEmission(const Ball& scene, const SurfacePoint&, Vec3 w) const {
  const float even = EvenShare();
  return {SkyPositionPdf(scene), even * UniformSpherePdf() + (1 - even) * PdfIncident({}, {}, -w)};
}

// What falls through the grid of a cube map keeps a little of the choice among lights.
float EnvironmentLight::Power(const Ball& scene) const {
  constexpr float kLeastOfCubeMap = 1e-3f;
  const float irradiance = cube_map_ ? std::max(irradiance_, kLeastOfCubeMap) : irradiance_;
  return 4 * irradiance * static_cast<float>(SkyDiskArea(scene));
}

}  // namespace candela
