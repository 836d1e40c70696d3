#pragma once

#include <cstring>
#include <ostream>
#include <span>
#include <string>
#include <vector>

#include "kernel/group.h"

namespace candela::test {

/// The ways to ask about a list of rays.
enum class Entry { kOneByOne, kScattered, kCoherent };
inline constexpr Entry kEntries[] = {Entry::kOneByOne, Entry::kScattered, Entry::kCoherent};

/// The nearest hits before each ray's t_max.
std::vector<HitRecord> IntersectList(const Group& group, Entry entry, std::span<const Ray> rays);
/// What `Occluded` says: 0 or 1.
std::vector<uint8_t> OccludedList(const Group& group, Entry entry, std::span<const Ray> rays);

/// The instruction sets of this machine; and each with both qualities, and the other accelerators.
std::vector<Isa> SupportedIsas();
std::vector<BuildOptions> AllBuildOptions();
/// Those with the kernel's own tree.
std::vector<BuildOptions> TreeBuildOptions();

/// Bit for bit, so that 0 is not -0.
inline bool IsSame(const HitRecord& a, const HitRecord& b) {
  return std::memcmp(&a, &b, sizeof(HitRecord)) == 0;
}

/// For messages.
std::string ToString(const HitRecord& hit);
std::string ToString(const Ray& ray);
std::string ToString(const BuildOptions& options);
std::string ToString(Entry entry);

}  // namespace candela::test
