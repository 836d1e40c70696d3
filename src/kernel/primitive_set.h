#pragma once

#include <cstdint>

#include "geometry/bounds3.h"
#include "geometry/hit_record.h"
#include "geometry/ray.h"

namespace candela {

/// Primitives that the kernel does not know: analytic shapes, curves. Two functions are all it
/// needs of them. Immutable; called concurrently.
class PrimitiveSet {
 public:
  virtual ~PrimitiveSet() = default;

  virtual uint32_t PrimitiveCount() const { return 1; }

  /// Moments at which boxes are known, evenly spread over times 0 to 1, the ends included; 1 for
  /// what does not move.
  virtual uint32_t TimeSteps() const { return 1; }

  /// A box around a primitive at a time step. At times between two steps the primitive stays within
  /// the box that lies linearly between theirs. `Bounds3::Infinite()` for an unbounded one, an
  /// empty box for one that is never hit.
  virtual Bounds3 PrimitiveBounds(uint32_t primitive, uint32_t step) const = 0;

  /// Looks for a hit with `ray.t_min <= t < hit->t` at `ray.time`. On success stores t, u and v and
  /// returns true; on a miss leaves `*hit` as it was.
  virtual bool IntersectPrimitive(const Ray& ray, uint32_t primitive, HitRecord* hit) const = 0;
};

/// Says which hits count, for surfaces with holes.
class HitFilter {
 public:
  virtual ~HitFilter() = default;

  /// Whether a hit counts. `ray` is the one that was asked for, in the space of the outermost
  /// group; all fields of `hit` are set. A pure function of the two, called concurrently, any
  /// number of times, also for hits that are replaced by nearer ones.
  virtual bool Accepts(const Ray& ray, const HitRecord& hit) const = 0;
};

}  // namespace candela
