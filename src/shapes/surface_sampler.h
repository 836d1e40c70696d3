#pragma once

#include <cmath>
#include <cstdint>

#include "geometry/surface_point.h"
#include "math/vec.h"

namespace candela {

/// A point of a surface as another point sees it.
struct SurfaceSample {
  Vec3 direction;      ///< Unit vector to the point of the surface.
  float distance = 0;  ///< A little short of it, by the rounding of both points: a ray of this
                       ///< length does not meet the surface there.
  Vec3 n;              ///< Unit normal, on the side that the definition of the surface says.
  float pdf = 0;       ///< Over solid angle; 0 when nothing was drawn.
};

/// A point of a surface, whoever sees it.
struct AreaSample {
  SurfacePoint point;  ///< Its place, the bound on its error, and its geometric normal.
  float pdf = 0;       ///< Over area; 0 when nothing was drawn.
};

/// Draws points of the surface of one object, in world space, for lights: as they are seen from
/// somewhere, such that where much of the light comes from many are drawn, and by area. What other
/// objects hide is not known here. Immutable; called concurrently.
class SurfaceSampler {
 public:
  virtual ~SurfaceSampler() = default;

  /// A point as it is seen from `from`, drawn with two numbers in [0, 1). Nothing for a `from`
  /// where rays that happen to hit the surface are the better way, like inside of a sphere, or
  /// where the surface cannot be told from its edge.
  virtual SurfaceSample Sample(Vec3 from, Vec2 u) const = 0;

  /// The density over solid angle with which `Sample(from)` draws the point `p` of the surface, the
  /// nearest in its direction, where the unit normal is `n`. 0 where it draws nothing.
  virtual float Pdf(Vec3 from, Vec3 p, Vec3 n) const = 0;

  /// A point of the whole surface, drawn with two numbers in [0, 1).
  virtual AreaSample SampleArea(Vec2 u) const = 0;

  /// The density over area with which that draws a point where the unit normal is `n`.
  virtual float PdfArea(Vec3 /*n*/) const { return static_cast<float>(1 / Area()); }

  /// Of one side.
  virtual double Area() const = 0;

  /// The unit normal of a surface that lies in a plane, in world space; 0 for others.
  virtual Vec3 FlatNormal() const { return {}; }

  virtual uint64_t MemoryBytes() const = 0;
};

// In the header, since path tracers ask for nothing as often.

/// A cosine from which on a point is seen edge-on.
inline constexpr float kEdgeOnCosine = 1e-6f;

/// The sample of a point that was drawn by area, from all of `area`.
inline SurfaceSample SampleByArea(const Vec3& from, const Vec3& p, const Vec3& n, double area) {
  const Vec3 way = p - from;
  const float squared = LengthSquared(way);
  const float distance = std::sqrt(squared);
  if (!(distance > 0)) return {};
  SurfaceSample sample;
  sample.direction = way * (1 / distance);
  sample.n = n;
  // The divisions below do not wait for the one above, and no product leaves the range of floats
  // before distances do.
  const float height = std::abs(Dot(n, way));  // Distance times cosine.
  // Rounding moves points by so much; a slanted surface is met that much earlier.
  const float rounding =
      (MaxAbs(from) + MaxAbs(p)) * 4e-6f * distance / (height + 0.001f * distance);
  sample.distance = distance - rounding - distance * 1e-5f;
  if (!(sample.distance > 0) || !(height > kEdgeOnCosine * distance)) return sample;
  sample.pdf = (squared / static_cast<float>(area)) * (distance / height);
  return sample;
}

/// Its density over solid angle: distance squared / (area cosine); 0 for a point seen edge-on.
inline float PdfByArea(const Vec3& from, const Vec3& p, const Vec3& n, double area) {
  const Vec3 way = p - from;
  const float squared = LengthSquared(way);
  const float distance = std::sqrt(squared);
  const float height = std::abs(Dot(n, way));  // Distance times cosine.
  if (!(height > kEdgeOnCosine * distance)) return 0;
  return (squared / static_cast<float>(area)) * (distance / height);
}

/// The sample of a point of a surface, which rays may leave: its error is bounded for a surface, or
/// a triangle of it, that reaches `size` far from `p`.
inline AreaSample SampleOfArea(const Vec3& p, const Vec3& n, float size, float pdf) {
  // As above: what the way from object space and back to it may round.
  const float error = (MaxAbs(p) + size) * 4e-6f;
  return {{p, {error, error, error}, n, n}, pdf};
}

/// Whether a flat surface of the given size around `p` is seen so small that drawing it by area, in
/// a fraction of the time, is as good as by solid angle: distance and cosine hardly vary.
inline bool IsFar(const Vec3& from, const Vec3& p, float size) {
  return LengthSquared(from - p) > 4 * size * size;
}

/// Whether a point lies in the plane through `p`, as well as single precision can tell. `size` is
/// that of what lies in the plane.
inline bool IsInPlane(const Vec3& from, const Vec3& p, const Vec3& n, float size) {
  const float rounding = (MaxAbs(from) + MaxAbs(p) + size) * 1e-5f;
  return std::abs(Dot(n, from - p)) <= rounding;
}

}  // namespace candela
