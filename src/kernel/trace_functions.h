#pragma once

#include <cstddef>
#include <cstdint>

#include "geometry/hit_record.h"
#include "geometry/ray.h"
#include "kernel/group_data.h"

namespace candela::kernel {

/// The searches, compiled for some lanes. What they do is said at `Group`.
struct TraceFunctions {
  int width;  ///< Of the nodes that they read.
  bool (*intersect)(const GroupData& group, const Ray& ray, HitRecord* hit);
  bool (*occluded)(const GroupData& group, const Ray& ray);
  void (*intersect_scattered)(const GroupData& group, const Ray* rays, HitRecord* hits,
                              size_t count);
  void (*occluded_scattered)(const GroupData& group, const Ray* rays, uint8_t* occluded,
                             size_t count);
  void (*intersect_coherent)(const GroupData& group, const Ray* rays, HitRecord* hits,
                             size_t count);
  void (*occluded_coherent)(const GroupData& group, const Ray* rays, uint8_t* occluded,
                            size_t count);
};

/// Those of an instruction set, for groups where everything rests and for others.
struct IsaFunctions {
  TraceFunctions resting, moving;
};

extern const IsaFunctions kScalarFunctions;
#ifdef CANDELA_X86
extern const IsaFunctions kAvx2Functions;
extern const IsaFunctions kAvx512Functions;     ///< For nodes of 8,
extern const IsaFunctions kAvx512x16Functions;  ///< and of 16.
#endif

}  // namespace candela::kernel
