#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "geometry/hit_record.h"
#include "geometry/ray.h"
#include "integrators/integrator.h"
#include "scene/scene.h"

namespace candela {

/// So many samples are followed together: enough to keep the memory busy, few enough to stay in the
/// cache.
constexpr size_t kMostTogether = 1024;

/// Calls `follow(samples, output)` for so many samples after the others, with what belongs to them.
template <class Follow>
void ForEachPart(std::span<const SampleRequest> samples, const SampleOutput& output,
                 size_t together, Follow follow) {
  for (size_t begin = 0; begin < samples.size(); begin += together) {
    const size_t count = std::min(together, samples.size() - begin);
    follow(samples.subspan(begin, count), output.Part(begin, count));
  }
}

/// Makes room for the first `size` entries; those behind them, and their memory, are kept for
/// later.
template <class T>
std::span<T> FirstOf(std::vector<T>* list, size_t size) {
  if (list->size() < size) list->resize(size);
  return {list->data(), size};
}

/// Paths that are followed together, bounce by bounce. Entry i of each list belongs to the same
/// path: what is known of it, or the number by which that is found, the ray that it goes along, and
/// where that ray ends.
template <class State>
class PathQueue {
 public:
  std::span<State> states() { return {states_.data(), size_}; }
  std::span<Ray> rays() { return {rays_.data(), size_}; }
  std::span<HitRecord> hits() { return {hits_.data(), size_}; }
  size_t size() const { return size_; }

  /// New entries are to be filled.
  void Resize(size_t size) {
    FirstOf(&states_, size);
    FirstOf(&rays_, size);
    FirstOf(&hits_, size);
    size_ = size;
  }

  void FindHits(const Scene& scene, RayOrder order) {
    static constexpr HitRecord kFarAway;
    for (HitRecord& hit : hits()) hit = kFarAway;
    scene.Intersect(order, rays(), hits());
  }

  /// Moves an entry forward, into the place of one that has ended.
  void MoveTo(size_t to, size_t from) {
    if (to == from) return;
    states_[to] = states_[from];
    rays_[to] = rays_[from];
    hits_[to] = hits_[from];
  }

 private:
  size_t size_ = 0;
  std::vector<State> states_;
  std::vector<Ray> rays_;
  std::vector<HitRecord> hits_;
};

}  // namespace candela
