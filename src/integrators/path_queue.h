#pragma once

#include <cstddef>
#include <vector>

#include "geometry/hit_record.h"
#include "geometry/ray.h"
#include "scene/scene.h"

namespace candela {

/// Paths that are followed together, bounce by bounce. Entry i of each list belongs to the same
/// path: what is known of it, the ray that it goes along, and where that ray ends.
template <class State>
struct PathQueue {
  std::vector<State> states;
  std::vector<Ray> rays;
  std::vector<HitRecord> hits;

  size_t Size() const { return states.size(); }

  // Memory is kept for later.
  void Clear() {
    states.clear();
    rays.clear();
  }
  void Add(const State& state, const Ray& ray) {
    states.push_back(state);
    rays.push_back(ray);
  }

  void FindHits(const Scene& scene, RayOrder order) {
    static constexpr HitRecord kFarAway;
    hits.assign(Size(), kFarAway);
    scene.Intersect(order, rays, hits);
  }

  /// Moves an entry forward, into the place of one that has ended.
  void MoveTo(size_t to, size_t from) {
    if (to == from) return;
    states[to] = states[from];
    rays[to] = rays[from];
    hits[to] = hits[from];
  }

  /// Forgets the entries behind the first `size`.
  void Shorten(size_t size) {
    states.erase(states.begin() + static_cast<std::ptrdiff_t>(size), states.end());
    rays.resize(size);
    hits.resize(size);
  }
};

/// So many samples are followed together: enough to keep the memory busy, few enough to stay in the
/// cache, and few for one picture to take memory that nobody expects.
constexpr size_t kMostTogether = 1024;

}  // namespace candela
