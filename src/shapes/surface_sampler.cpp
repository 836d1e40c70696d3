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

SurfaceSample SampleByArea(Vec3 from, Vec3 p, Vec3 n, double area) {
  const Vec3 way = p - from;
  const float distance = Length(way);
  if (!(distance > 0)) return {};
  SurfaceSample sample;
  sample.direction = way / distance;
  sample.n = n;
  sample.pdf = PdfByArea(from, p, n, area);
  // Rounding moves points by so much; a slanted surface is met that much earlier.
  const float cosine = std::abs(Dot(n, sample.direction));
  const float rounding = (Largest(from) + Largest(p)) * 4e-6f / (cosine + 0.001f);
  sample.distance = distance - rounding - distance * 1e-5f;
  if (!(sample.distance > 0)) sample.pdf = 0;
  return sample;
}

float PdfByArea(Vec3 from, Vec3 p, Vec3 n, double area) {
  const Vec3d way = ToDouble(p) - ToDouble(from);
  const double squared = LengthSquared(way);
  const double height = std::abs(Dot(ToDouble(n), way));  // Distance times cosine.
  const double distance = std::sqrt(squared);
  if (!(height > kEdgeOn * distance)) return 0;
  return static_cast<float>(squared * distance / (area * height));
}

bool IsInPlane(Vec3 from, Vec3 p, Vec3 n, float size) {
  const float rounding = (Largest(from) + Largest(p) + size) * 1e-5f;
  return std::abs(Dot(n, from - p)) <= rounding;
}

}  // namespace candela
