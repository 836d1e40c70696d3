#include "shapes/rectangle.h"

#include <algorithm>

#include "geometry/triangle.h"

namespace candela {
namespace {

constexpr std::array<std::array<uint32_t, 3>, 2> kTriangles = {{{0, 1, 2}, {0, 2, 3}}};

/// Where a hit lies, in parts of the sides. Both triangles begin in the corner of the origin; the
/// diagonal from there is a side of each.
Vec2 PlaceOf(const HitRecord& hit) {
  const float sum = std::min(hit.u + hit.v, 1.0f);
  return hit.primitive == 0 ? Vec2{sum, hit.v} : Vec2{hit.u, sum};
}

}  // namespace

std::shared_ptr<const Shape> Rectangle::Create(ParamReader* params, ShapeContext*) {
  const float width = params->RequiredPositive("width");
  const float height = params->RequiredPositive("height");
  return std::make_shared<Rectangle>(width, height);
}

Rectangle::Rectangle(float width, float height) : normal_{0, 0, 1} {
  const float x = width / 2, y = height / 2;
  corners_ = {{{-x, -y, 0}, {x, -y, 0}, {x, y, 0}, {-x, y, 0}}};
}

Bounds3 Rectangle::ObjectBounds() const {
  Bounds3 bounds;
  for (const Vec3& corner : corners_) bounds.Extend(corner);
  return bounds;
}

bool Rectangle::Intersect(const Ray& ray, HitRecord* hit) const {
  const ShearedRay sheared(ray);
  bool found = false;
  for (uint32_t i = 0; i < kTriangles.size(); ++i) {
    const auto& [a, b, c] = kTriangles[i];
    if (!IntersectTriangle(sheared, ray.t_min, corners_[a], corners_[b], corners_[c], hit)) {
      continue;
    }
    hit->primitive = i;
    found = true;
  }
  return found;
}

SurfacePoint Rectangle::SurfaceAt(const Ray&, const HitRecord& hit) const {
  const auto& [ia, ib, ic] = kTriangles[hit.primitive];
  const Vec3 a = corners_[ia], b = corners_[ib], c = corners_[ic];
  return {TrianglePoint(a, b, c, hit.u, hit.v), TrianglePointError(a, b, c, hit.u, hit.v), normal_,
          normal_};
}

// From 0 to 1 along either side.
void Rectangle::AddTextureCoordinates(const HitRecord& hit, SurfacePoint* point) const {
  point->uv = PlaceOf(hit);
  point->dpdu = SideX();
  point->dpdv = SideY();
}

std::optional<TriangleInput> Rectangle::Triangles() const {
  return TriangleInput{corners_, kTriangles};
}

std::shared_ptr<const Shape> Rectangle::Baked(const Mat4& world_from_object) const {
  const auto object_from_world = InverseAffine(world_from_object);
  if (!object_from_world) return nullptr;
  std::shared_ptr<Rectangle> baked(new Rectangle());
  for (size_t i = 0; i < corners_.size(); ++i) {
    baked->corners_[i] = ToFloat(TransformPoint(world_from_object, ToDouble(corners_[i])));
    if (!IsFinite(baked->corners_[i])) return nullptr;
  }
  baked->normal_ = ToFloat(Normalize(TransformNormal(*object_from_world, ToDouble(normal_))));
  return baked;
}

}  // namespace candela
