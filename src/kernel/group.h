#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <utility>

#include "base/cancel_token.h"
#include "base/isa.h"
#include "base/result.h"
#include "geometry/bounds3.h"
#include "geometry/hit_record.h"
#include "geometry/ray.h"
#include "kernel/accelerator_kind.h"
#include "kernel/group_data.h"
#include "kernel/group_input.h"

namespace candela {

/// How much time a tree is worth.
enum class BuildQuality {
  kFast,  ///< Binned surface area heuristic.
  kBest,  ///< And triangles split where their boxes overlap.
};

struct BuildOptions {
  BuildQuality quality = BuildQuality::kFast;
  Isa isa = DefaultIsa();
  const CancelToken* cancel = nullptr;  ///< May be null.
  /// Children of a node: 8, or 16 with AVX-512. Renderers trace lists of rays, which are faster
  /// with 8; who traces single rays gains with 16. The answers are the same.
  int width = 8;
  /// The others have no quality, no width and no instruction set, and cannot be refitted.
  AcceleratorKind accelerator = AcceleratorKind::kBvh;
};

/// How the rays of a list lie. Only a hint: the result is the same for both.
enum class RayOrder {
  kScattered,  ///< Bounces and the like: each on its own way, many of them in flight at once.
  kCoherent,   ///< Neighbours go the same way, 16 at a time: camera rays, tile by tile.
};

/// Triangles, primitives and instances of other groups under one tree: what answers the two
/// questions of ray tracing. Immutable once built; all queries may run concurrently.
///
/// A ray misses when it has a NaN, an infinite origin, or a direction whose squared length is 0 or
/// infinite. Of equal t the smaller (object, nested..., primitive) wins, in lexicographic order; a
/// closed mesh has no gaps between its triangles. The answers are the same bits for any instruction
/// set, order of rays, list length and number of threads.
class Group {
 public:
  /// Builds on all threads (see `ThreadLimit`). Fails with `kResources` when memory is short or
  /// groups nest too deeply, with `kUsage` for an instance that cannot be (see `InstanceInput`),
  /// with `kStopped` when cancelled.
  static Result<std::unique_ptr<Group>> Build(GroupInput input, const BuildOptions& options);

  Group(const Group&) = delete;
  Group& operator=(const Group&) = delete;

  /// Looks for the nearest hit with `ray.t_min <= t < hit->t`. On success fills `*hit` and returns
  /// true; on a miss leaves it as it was.
  bool Intersect(const Ray& ray, HitRecord* hit) const;

  /// Whether anything lies in `ray.t_min <= t < ray.t_max`.
  bool Occluded(const Ray& ray) const;

  /// `Intersect` and `Occluded` for many rays. The spans are equally long; `hits` start as for one
  /// ray; `occluded` is set to 0 or 1.
  void Intersect(RayOrder order, std::span<const Ray> rays, std::span<HitRecord> hits) const;
  void Occluded(RayOrder order, std::span<const Ray> rays, std::span<uint8_t> occluded) const;

  /// Takes new positions for the triangles, in the form and number of the old ones, and new boxes
  /// of primitives and instances, and keeps the shape of the tree: quick, and good as long as
  /// things stay near each other. What was left out when the group was built, without area or box,
  /// stays so; masks and filters stay, too. Fails with `kUsage` for other items, and where there is
  /// no tree (`BuildOptions::accelerator`). Not concurrently with queries.
  Result<void> Refit(const GroupInput& input);

  /// The box around all bounded items at all times.
  Bounds3 Bounds() const { return data_.bounds; }
  /// Whether some of it is unbounded, and stands beside the tree.
  bool HasUnbounded() const;
  /// Nodes of the kernel's tree on the longest way down.
  int Depth() const { return data_.depth; }
  /// The instruction set that searches it.
  Isa isa() const { return data_.isa; }
  AcceleratorKind accelerator() const { return data_.accelerator; }
  /// Of what finds the hits alone: for the kernel's tree records and triangle ids.
  uint64_t MemoryBytes() const;

  /// For the kernel's own code.
  const kernel::GroupData& data() const { return data_; }

 private:
  explicit Group(kernel::GroupData data) : data_(std::move(data)) {}

  kernel::GroupData data_;
};

}  // namespace candela
