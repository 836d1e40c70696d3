#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "base/result.h"
#include "bench_scene.h"
#include "kernel/group.h"

namespace candela {

/// A scene in our kernel.
class OurGroup {
 public:
  /// Builds on all threads; nodes have `width` children.
  static Result<OurGroup> Build(const BenchScene& scene, BuildQuality quality, int width = 8);

  /// Of the trees alone.
  uint64_t MemoryBytes() const;

  /// Ray by ray. The spans are equally long; hits start fresh, with t = t_max.
  void Intersect(std::span<const Ray> rays, std::span<HitRecord> hits) const;
  void Occluded(std::span<const Ray> rays, std::span<uint8_t> occluded) const;

  /// What answers lists of rays.
  const Group& group() const { return *group_; }

 private:
  std::shared_ptr<const Group> part_;  ///< What is instanced, if anything.
  std::shared_ptr<const Group> group_;
};

}  // namespace candela
