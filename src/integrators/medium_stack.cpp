#include "integrators/medium_stack.h"

#include <algorithm>
#include <iterator>
#include <vector>

#include "geometry/spawn_ray.h"

namespace candela {
namespace {

/// Where a ray leaves a body without having entered it: one that may be around its origin.
struct Exit {
  uint32_t interior;
  bool is_endless;  ///< The surface is.
};

/// In their order. Several bodies may have the same interior.
std::vector<Exit> ExitsOf(const Scene& scene, Vec3 from, Vec3 direction, float time) {
  constexpr int kFarEnough = 100000;  // Surfaces: a line through a fractal has an end, too.
  std::vector<Exit> exits;
  std::vector<uint32_t> entered;
  Ray ray(from, direction);
  ray.time = time;
  for (int i = 0; i < kFarEnough; ++i) {
    HitRecord hit;
    if (!scene.Intersect(ray, &hit)) break;
    const SurfacePoint point = scene.SurfaceAt(ray, hit);
    const SceneObject& object = scene.objects()[hit.object];
    const uint32_t interior = object.interior;
    if (interior != SceneObject::kNoInterior) {
      const auto same = std::find(entered.begin(), entered.end(), interior);
      if (Dot(point.OutwardNormal(), direction) <= 0) {
        entered.push_back(interior);
      } else if (same != entered.end()) {
        entered.erase(same);
      } else {
        exits.push_back({interior, !object.shape->ObjectBounds().IsFinite()});
      }
    }
    ray = SpawnRay(point, direction);
    ray.time = time;
  }
  return exits;
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

MediumStack MediaAround(const Scene& scene, Vec3 p, float time) {
  MediumStack media;
  if (scene.interiors().empty()) return media;
  // Any direction does that is not along the usual walls.
  const Vec3 direction = Normalize(Vec3{0.36f, 0.51f, 0.78f});
  const std::vector<Exit> ahead = ExitsOf(scene, p, direction, time);
  std::vector<Exit> behind = ExitsOf(scene, p, -direction, time);
  // A body is left both ways, but for one without end, like the water under a plane. Any other that
  // is left one way only is open, and what is behind its surface nobody can tell.
  std::vector<Exit> around;
  for (const Exit& exit : ahead) {
    const auto same = std::find_if(behind.begin(), behind.end(), [&](const Exit& other) {
      return other.interior == exit.interior;
    });
    const bool is_both_ways = same != behind.end();
    if (is_both_ways) behind.erase(same);
    if (is_both_ways || exit.is_endless) around.push_back(exit);
  }
  std::copy_if(behind.begin(), behind.end(), std::back_inserter(around),
               [](const Exit& exit) { return exit.is_endless; });
  // What light leaves last it has entered first.
  std::for_each(around.rbegin(), around.rend(),
                [&](const Exit& exit) { media.Enter(exit.interior); });
  return media;
}

}  // namespace candela
