#include "integrators/medium_stack.h"

#include <algorithm>
#include <set>
#include <vector>

#include "geometry/spawn_ray.h"

namespace candela {
namespace {

/// The surface of a body along a line.
struct Crossing {
  uint32_t interior;
  bool is_exit;
};

/// The first surface of each body on the way, in their order.
std::vector<Crossing> FirstCrossings(const Scene& scene, Vec3 from, Vec3 direction, Bodies bodies) {
  constexpr int kFarEnough = 100000;  // Surfaces: a line through a fractal has an end, too.
  std::vector<Crossing> crossings;
  std::set<uint32_t> met;
  Ray ray(from, direction);
  for (int i = 0; i < kFarEnough; ++i) {
    HitRecord hit;
    if (!scene.Intersect(ray, &hit)) break;
    const SurfacePoint point = scene.SurfaceAt(ray, hit);
    const uint32_t interior = scene.objects()[hit.object].interior;
    const bool counts = interior != SceneObject::kNoInterior &&
                        (bodies == Bodies::kAll || scene.interiors()[interior].is_explicit);
    if (counts && met.insert(interior).second) {
      crossings.push_back({interior, Dot(point.OutwardNormal(), direction) > 0});
    }
    ray = SpawnRay(point, direction);
  }
  return crossings;
}

}  // namespace

uint32_t MediumStack::Top(std::span<const Interior> interiors) const {
  uint32_t top = entered_[0];
  for (uint32_t i = 1; i < count_; ++i) {
    if (interiors[entered_[i]].priority >= interiors[top].priority) top = entered_[i];
  }
  return top;
}

void MediumStack::Leave(uint32_t interior) {
  for (uint32_t i = count_; i-- > 0;) {
    if (entered_[i] != interior) continue;
    for (uint32_t j = i + 1; j < count_; ++j) entered_[j - 1] = entered_[j];
    --count_;
    return;
  }
}

bool MediumStack::Hides(std::span<const Interior> interiors, uint32_t interior, bool enters) const {
  if (IsEmpty() || !interiors[interior].is_explicit) return false;
  // Inside of the body itself, and where one of several that have the same interior ends, too.
  const uint32_t top = Top(interiors);
  if (enters) return top == interior || interiors[top].priority > interiors[interior].priority;
  if (!Contains(interior)) return interiors[top].priority >= interiors[interior].priority;
  MediumStack rest = *this;
  rest.Leave(interior);
  return top != interior || rest.Contains(interior);
}

bool MediumStack::Contains(uint32_t interior) const {
  return std::find(entered_.begin(), entered_.begin() + count_, interior) !=
         entered_.begin() + count_;
}

MediumStack MediaAround(const Scene& scene, Vec3 p, Bodies bodies) {
  MediumStack media;
  if (scene.interiors().empty()) return media;
  // Any direction does that is not along the usual walls.
  const Vec3 direction = Normalize(Vec3{0.36f, 0.51f, 0.78f});
  const auto ahead = FirstCrossings(scene, p, direction, bodies);
  const auto behind = FirstCrossings(scene, p, -direction, bodies);
  const auto is_entered = [](const std::vector<Crossing>& crossings, uint32_t interior) {
    for (const Crossing& each : crossings) {
      if (each.interior == interior) return !each.is_exit;
    }
    return false;
  };
  // What light leaves last it has entered first.
  for (const auto* way : {&behind, &ahead}) {
    for (size_t i = way->size(); i-- > 0;) {
      const auto& [interior, is_exit] = (*way)[i];
      const auto& other = way == &ahead ? behind : ahead;
      if (!is_exit || is_entered(other, interior) || media.Contains(interior)) continue;
      media.Enter(interior);
    }
  }
  return media;
}

}  // namespace candela
