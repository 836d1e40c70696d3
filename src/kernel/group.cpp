#include "kernel/group.h"

#include <algorithm>
#include <cmath>
#include <new>
#include <utility>

#include "base/check.h"
#include "kernel/accelerators/accelerator.h"
#include "kernel/accelerators/build_accelerated.h"
#include "kernel/build_group.h"
#include "kernel/trace_functions.h"

namespace candela {
namespace {

const kernel::IsaFunctions& FunctionsOf(Isa isa, int width) {
  CHECK(width == 8 || (width == 16 && isa == Isa::kAvx512));
#ifdef CANDELA_X86
  if (isa == Isa::kAvx512) {
    return width == 8 ? kernel::kAvx512Functions : kernel::kAvx512x16Functions;
  }
  if (isa == Isa::kAvx2) return kernel::kAvx2Functions;
#endif
  CHECK(isa == Isa::kScalar);
  return kernel::kScalarFunctions;
}

float LargestCoordinate(const Bounds3& bounds) {
  if (bounds.IsEmpty()) return 0;
  const Vec3 largest = Max(Abs(bounds.min), Abs(bounds.max));
  return std::max({largest.x, largest.y, largest.z});
}

/// Short, so that no memory is needed to tell.
Error NoMemory() {
  return {ErrorCode::kResources, "out of memory"};
}

}  // namespace

Result<std::unique_ptr<Group>> Group::Build(GroupInput input, const BuildOptions& options) {
  try {
    const bool has_tree = options.accelerator == AcceleratorKind::kBvh;
    auto data = has_tree ? kernel::BuildGroup(input, options.quality, options.width, options.cancel)
                         : kernel::BuildAccelerated(input, options);
    if (!data) return data.error();
    if (has_tree) {
      data->isa = options.isa;
      const kernel::IsaFunctions& functions = FunctionsOf(options.isa, options.width);
      data->trace = data->moves ? &functions.moving : &functions.resting;
    }
    data->largest_coordinate = LargestCoordinate(data->bounds);
    return std::unique_ptr<Group>(new Group(std::move(*data)));
  } catch (const std::bad_alloc&) {
    return NoMemory();
  }
}

bool Group::Intersect(const Ray& ray, HitRecord* hit) const {
  return data_.trace->intersect(data_, ray, hit);
}

bool Group::Occluded(const Ray& ray) const {
  return data_.trace->occluded(data_, ray);
}

void Group::Intersect(RayOrder order, std::span<const Ray> rays, std::span<HitRecord> hits) const {
  CHECK(rays.size() == hits.size());
  const auto intersect = order == RayOrder::kCoherent ? data_.trace->intersect_coherent
                                                      : data_.trace->intersect_scattered;
  intersect(data_, rays.data(), hits.data(), rays.size());
}

void Group::Occluded(RayOrder order, std::span<const Ray> rays, std::span<uint8_t> occluded) const {
  CHECK(rays.size() == occluded.size());
  const auto test = order == RayOrder::kCoherent ? data_.trace->occluded_coherent
                                                 : data_.trace->occluded_scattered;
  test(data_, rays.data(), occluded.data(), rays.size());
}

Result<void> Group::Refit(const GroupInput& input) {
  if (data_.structure) {
    return Error{ErrorCode::kUsage, "only the kernel's own tree can be refitted"};
  }
  try {
    auto done = kernel::RefitGroup(input, &data_);
    data_.largest_coordinate = LargestCoordinate(data_.bounds);
    return done;
  } catch (const std::bad_alloc&) {
    return NoMemory();
  }
}

bool Group::HasUnbounded() const {
  return data_.structure ? !data_.structure->table().unbounded.empty() : !data_.unbounded.empty();
}

uint64_t Group::MemoryBytes() const {
  uint64_t bytes = 0;
  for (const auto& item : data_.items) bytes += item.motion.MemoryBytes();
  if (data_.structure) return bytes + data_.structure->MemoryBytes();
  return bytes + data_.records.size() * sizeof(kernel::Record) +
         data_.triangle_ids.capacity() * sizeof(uint32_t);
}

}  // namespace candela
