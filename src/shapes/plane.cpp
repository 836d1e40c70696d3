#include "shapes/plane.h"

#include <algorithm>
#include <cmath>

#include "math/frame.h"

namespace candela {

std::shared_ptr<const Shape> Plane::Create(ParamReader* params, ShapeContext*) {
  const Vec3 normal = params->RequiredDirection("normal");
  const float offset = params->RequiredNumber("offset");
  return std::make_unique<Plane>(normal, offset);
}

// Scaled by a power of two, which rounds nothing, so that the squares of its length are ordinary
// numbers.
Plane::Plane(Vec3 normal, float offset) {
  int exponent;
  std::frexp(normal[LargestAxis(normal)], &exponent);
  const auto scaled = [exponent](float value) { return std::ldexp(value, -exponent); };
  normal_ = {scaled(normal.x), scaled(normal.y), scaled(normal.z)};
  offset_ = scaled(offset);
}

// Inserting p = o + t d into Dot(n, p) = offset gives one linear equation.
bool Plane::Intersect(const Ray& ray, HitRecord* hit) const {
  const float approach = Dot(normal_, ray.direction);
  if (approach == 0) return false;  // Parallel: no hit, or the whole ray lies inside.

  const float t = (offset_ - Dot(normal_, ray.origin)) / approach;
  if (!(t >= ray.t_min && t < hit->t)) return false;  // Written so that NaN is a miss.
  hit->t = t;
  hit->u = hit->v = 0;
  hit->primitive = 0;
  return true;
}

SurfacePoint Plane::SurfaceAt(const Ray& ray, const HitRecord& hit) const {
  // Moved onto the plane; what remains is the rounding of its coordinates and of the offset.
  const Vec3 p = ray.At(hit.t);
  const Vec3 on_plane = p + normal_ * ((offset_ - Dot(normal_, p)) / Dot(normal_, normal_));
  // Not 0 in the origin itself, where halving the smallest float would lead back to the plane.
  const float error = std::max(MaxAbs(on_plane) * 6e-7f, 1e-30f);
  return {on_plane, {error, error, error}, normal_, normal_};
}

// Lengths along two axes in the plane; on a floor with the normal y these are x and -z.
void Plane::AddTextureCoordinates(const HitRecord&, SurfacePoint* point) const {
  const Frame frame = Frame::FromNormal(Normalize(normal_));
  point->uv = {Dot(point->p, frame.x), Dot(point->p, frame.y)};
  point->dpdu = frame.x;
  point->dpdv = frame.y;
}

}  // namespace candela
