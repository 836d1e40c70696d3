#pragma once

#include <cstddef>
#include <cstdint>

#include "geometry/hit_record.h"
#include "geometry/ray.h"
#include "kernel/group_data.h"

namespace candela::kernel {

/// The searches, compiled for one instruction set. What they do is said at `Group`.
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

extern const TraceFunctions kScalarFunctions;
#ifdef CANDELA_X86
extern const TraceFunctions kAvx2Functions;
extern const TraceFunctions kAvx512Functions;     ///< For nodes of 8,
extern const TraceFunctions kAvx512x16Functions;  ///< and of 16.
#endif

}  // namespace candela::kernel
