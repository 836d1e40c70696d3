#include "shapes/registry.h"

#include "scene_spec/registry.h"
#include "shapes/disk.h"
#include "shapes/mesh.h"
#include "shapes/plane.h"
#include "shapes/rectangle.h"
#include "shapes/sphere.h"
#include "shapes/triangle.h"

namespace candela {
namespace {

constexpr ShapeEntry kShapes[] = {
    // name     create             example
    {"sphere", &Sphere::Create, "type sphere radius 1"},
    {"plane", &Plane::Create, "type plane normal 0 1 0 offset -1"},
    {"triangle", &Triangle::Create, "type triangle vertex0 0 0 0 vertex1 1 0 0 vertex2 0 1 0"},
    {"rectangle", &Rectangle::Create, "type rectangle width 2 height 1"},
    {"disk", &Disk::Create, "type disk radius 1"},
    {"mesh", &Mesh::Create, "type mesh obj_file models/cube.obj"},
};

}  // namespace

std::span<const ShapeEntry> ShapeEntries() {
  return kShapes;
}

std::shared_ptr<const Shape> CreateShape(const TypedSpec& spec, ShapeContext* context) {
  const ShapeEntry* entry = FindEntry<ShapeEntry>(kShapes, spec, "shape", context->diagnostics);
  if (!entry) return nullptr;
  ParamReader params(spec.params, entry->name, spec.where, context->diagnostics, context->resolved);
  auto shape = entry->create(&params, context);
  params.Finish();
  return shape;
}

}  // namespace candela
