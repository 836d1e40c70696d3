#include "integrators/symmetric_media.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <vector>

#include "geometry/bounds3.h"
#include "scene/interior.h"

namespace candela {
namespace {

struct Body {
  size_t object;
  Bounds3 box;
};

/// Whether it counts which of the two light has got into last.
bool OrderCounts(const Interior& a, const Interior& b) {
  if (a.priority != b.priority || a.Key() == b.Key()) return false;
  return a.is_explicit || b.is_explicit || a.medium.absorption != b.medium.absorption;
}

bool Overlap(const Bounds3& a, const Bounds3& b) {
  for (int axis = 0; axis < 3; ++axis) {
    if (a.min[axis] >= b.max[axis] || b.min[axis] >= a.max[axis]) return false;
  }
  return true;
}

/// From left to right.
std::vector<Body> BodiesOf(const Scene& scene) {
  std::vector<Body> bodies;
  for (size_t i = 0; i < scene.objects().size(); ++i) {
    const SceneObject& object = scene.objects()[i];
    if (object.interior == SceneObject::kNoInterior) continue;
    bodies.push_back({i, object.WorldBounds()});
  }
  std::stable_sort(bodies.begin(), bodies.end(),
                   [](const Body& a, const Body& b) { return a.box.min.x < b.box.min.x; });
  return bodies;
}

}  // namespace

void CheckMediaAreSymmetric(const Scene& scene, std::string_view integrator,
                            Diagnostics* diagnostics) {
  if (scene.interiors().size() < 2) return;
  const std::vector<Body> bodies = BodiesOf(scene);
  std::vector<bool> is_reported(scene.objects().size());
  for (size_t i = 0; i < bodies.size(); ++i) {
    const SceneObject& a = scene.objects()[bodies[i].object];
    for (size_t j = i + 1; j < bodies.size() && bodies[j].box.min.x < bodies[i].box.max.x; ++j) {
      const SceneObject& b = scene.objects()[bodies[j].object];
      const auto [first, second] = std::minmax(bodies[i].object, bodies[j].object);
      if (is_reported[second]) continue;
      if (!OrderCounts(scene.interiors()[a.interior], scene.interiors()[b.interior])) continue;
      if (!Overlap(bodies[i].box, bodies[j].box)) continue;
      is_reported[second] = true;
      const SourceLocation& place = scene.PlaceOfObject(second);
      if (diagnostics->IsFull(place)) return;
      diagnostics->Error(
          place,
          fmt::format("the {} and the {} at {} may overlap and have the same priority, so "
                      "what fills the place depends on where light comes from, which the "
                      "integrator '{}' cannot follow; give them an 'Interior' with different "
                      "priorities",
                      scene.objects()[second].type, scene.objects()[first].type,
                      ToString(scene.PlaceOfObject(first)), integrator));
    }
  }
}

}  // namespace candela
