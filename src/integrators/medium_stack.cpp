#include "integrators/medium_stack.h"

#include <algorithm>
#include <vector>

#include "geometry/spawn_ray.h"

namespace candela {
namespace {

/// The bodies that a ray leaves without having entered them, in this order: those around its
/// origin. Several may have the same interior.
std::vector<uint32_t> BodiesLeft(const Scene& scene, Vec3 from, Vec3 direction) {
  constexpr int kFarEnough = 100000;  // Surfaces: a line through a fractal has an end, too.
  std::vector<uint32_t> left, entered;
  Ray ray(from, direction);
  for (int i = 0; i < kFarEnough; ++i) {
    HitRecord hit;
    if (!scene.Intersect(ray, &hit)) break;
    const SurfacePoint point = scene.SurfaceAt(ray, hit);
    const uint32_t interior = scene.objects()[hit.object].interior;
    if (interior != SceneObject::kNoInterior) {
      const auto same = std::find(entered.begin(), entered.end(), interior);
      if (Dot(point.OutwardNormal(), direction) <= 0) {
        entered.push_back(interior);
      } else if (same != entered.end()) {
        entered.erase(same);
      } else {
        left.push_back(interior);
      }
    }
    ray = SpawnRay(point, direction);
  }
  return left;
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
  return top != interior || (!rest.IsEmpty() && rest.Top(interiors) == interior);
}

bool MediumStack::Contains(uint32_t interior) const {
  return std::find(entered_.begin(), entered_.begin() + count_, interior) !=
         entered_.begin() + count_;
}

MediumStack MediaAround(const Scene& scene, Vec3 p) {
  MediumStack media;
  if (scene.interiors().empty()) return media;
  // Any direction does that is not along the usual walls.
  const Vec3 direction = Normalize(Vec3{0.36f, 0.51f, 0.78f});
  const std::vector<uint32_t> ahead = BodiesLeft(scene, p, direction);
  // A closed body is left both ways; one without end, like the water under a plane, only by one.
  std::vector<uint32_t> behind = BodiesLeft(scene, p, -direction);
  for (const uint32_t interior : ahead) {
    const auto same = std::find(behind.begin(), behind.end(), interior);
    if (same != behind.end()) behind.erase(same);
  }
  // What light leaves last it has entered first.
  for (const auto& way : {behind, ahead}) {
    std::for_each(way.rbegin(), way.rend(), [&](uint32_t interior) { media.Enter(interior); });
  }
  return media;
}

}  // namespace candela
