#include "shapes/surface_sampler.h"

#include <algorithm>
#include <cmath>

namespace candela {
namespace {

/// A cosine from which on a point is seen edge-on.
constexpr float kEdgeOn = 1e-6f;

float Largest(Vec3 v) {
  return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

}  // namespace

SurfaceSample SampleByArea(const Vec3& from, const Vec3& p, const Vec3& n, double area) {
  const Vec3 way = p - from;
  const float squared = LengthSquared(way);
  const float distance = std::sqrt(squared);
  if (!(distance > 0)) return {};
  SurfaceSample sample;
  sample.direction = way * (1 / distance);
  sample.n = n;
  // Rounding moves points by so much; a slanted surface is met that much earlier.
  const float cosine = std::abs(Dot(n, sample.direction));
  const float rounding = (Largest(from) + Largest(p)) * 4e-6f / (cosine + 0.001f);
  sample.distance = distance - rounding - distance * 1e-5f;
  if (!(sample.distance > 0) || !(cosine > kEdgeOn)) return sample;
  sample.pdf = squared / (static_cast<float>(area) * cosine);
  return sample;
}

float PdfByArea(Vec3 from, Vec3 p, Vec3 n, double area) {
  const Vec3 way = p - from;
  const float squared = LengthSquared(way);
  const float distance = std::sqrt(squared);
  const float height = std::abs(Dot(n, way));  // Distance times cosine.
  if (!(height > kEdgeOn * distance)) return 0;
  return squared * distance / (static_cast<float>(area) * height);
}

AreaSample SampleOfArea(Vec3 p, Vec3 n, float size, float pdf) {
  // As above: what the way from object space and back to it may round.
  const float error = (Largest(p) + size) * 4e-6f;
  return {{p, {error, error, error}, n, n}, pdf};
}

bool IsFar(Vec3 from, Vec3 p, float size) {
  return LengthSquared(from - p) > 4 * size * size;
}

bool IsInPlane(Vec3 from, Vec3 p, Vec3 n, float size) {
  const float rounding = (Largest(from) + Largest(p) + size) * 1e-5f;
  return std::abs(Dot(n, from - p)) <= rounding;
}

}  // namespace candela
