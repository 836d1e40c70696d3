#include "shapes/triangle.h"

#include "shapes/shape_context.h"

namespace candela {

std::shared_ptr<const Shape> Triangle::Create(ParamReader* params, ShapeContext* context) {
  const Vec3 a = params->RequiredVector("vertex0");
  const Vec3 b = params->RequiredVector("vertex1");
  const Vec3 c = params->RequiredVector("vertex2");
  auto triangle = std::make_unique<Triangle>(a, b, c);
  const bool is_complete =
      params->Has("vertex0") && params->Has("vertex1") && params->Has("vertex2");
  if (is_complete && triangle->normal_ == Vec3()) {
    context->diagnostics->Warning(context->where, "the triangle has no area and is left out");
    return nullptr;
  }
  return triangle;
}

Bounds3 Triangle::ObjectBounds() const {
  Bounds3 bounds;
  for (const Vec3& corner : corners_) bounds.Extend(corner);
  return bounds;
}

bool Triangle::Intersect(const Ray& ray, HitRecord* hit) const {
  if (!IntersectTriangle(ShearedRay(ray), ray.t_min, corners_[0], corners_[1], corners_[2], hit)) {
    return false;
  }
  hit->primitive = 0;
  return true;
}

SurfacePoint Triangle::SurfaceAt(const Ray&, const HitRecord& hit) const {
  return {TrianglePoint(corners_[0], corners_[1], corners_[2], hit.u, hit.v),
          TrianglePointError(corners_[0], corners_[1], corners_[2], hit.u, hit.v), normal_,
          normal_};
}

void Triangle::AddTextureCoordinates(const HitRecord& hit, SurfacePoint* point) const {
  point->uv = {hit.u, hit.v};
  point->dpdu = corners_[1] - corners_[0];
  point->dpdv = corners_[2] - corners_[0];
}

}  // namespace candela
