#include "tests/kernel/trace_lists.h"

#include <cstdio>

namespace candela::test {

std::vector<HitRecord> IntersectList(const Group& group, Entry entry, std::span<const Ray> rays) {
  std::vector<HitRecord> hits(rays.size());
  for (size_t i = 0; i < rays.size(); ++i) hits[i].t = rays[i].t_max;
  if (entry == Entry::kOneByOne) {
    for (size_t i = 0; i < rays.size(); ++i) group.Intersect(rays[i], &hits[i]);
  } else {
    group.Intersect(entry == Entry::kCoherent ? RayOrder::kCoherent : RayOrder::kScattered, rays,
                    hits);
  }
  return hits;
}

std::vector<uint8_t> OccludedList(const Group& group, Entry entry, std::span<const Ray> rays) {
  std::vector<uint8_t> occluded(rays.size(), 0xFF);
  if (entry == Entry::kOneByOne) {
    for (size_t i = 0; i < rays.size(); ++i) occluded[i] = group.Occluded(rays[i]);
  } else {
    group.Occluded(entry == Entry::kCoherent ? RayOrder::kCoherent : RayOrder::kScattered, rays,
                   occluded);
  }
  return occluded;
}

std::vector<Isa> SupportedIsas() {
  std::vector<Isa> isas;
  for (const Isa isa : {Isa::kScalar, Isa::kAvx2, Isa::kAvx512}) {
    if (IsSupported(isa)) isas.push_back(isa);
  }
  return isas;
}

std::vector<BuildOptions> TreeBuildOptions() {
  std::vector<BuildOptions> all;
  for (const Isa isa : SupportedIsas()) {
    for (const BuildQuality quality : {BuildQuality::kFast, BuildQuality::kBest}) {
      all.push_back({quality, isa, nullptr, 8});
      if (isa == Isa::kAvx512) all.push_back({quality, isa, nullptr, 16});
    }
  }
  return all;
}

std::vector<BuildOptions> AllBuildOptions() {
  std::vector<BuildOptions> all = TreeBuildOptions();
  for (const AcceleratorEntry& entry : Accelerators()) {
    if (entry.kind == AcceleratorKind::kBvh) continue;
    BuildOptions options;
    options.accelerator = entry.kind;
    all.push_back(options);
  }
  return all;
}

std::string ToString(const HitRecord& hit) {
  char text[200];
  std::snprintf(text, sizeof text,
                "t %a (%.9g) u %a v %a object %d primitive %u nested %d %d %d %d",
                static_cast<double>(hit.t), static_cast<double>(hit.t), static_cast<double>(hit.u),
                static_cast<double>(hit.v), static_cast<int>(hit.object), hit.primitive,
                static_cast<int>(hit.nested[0]), static_cast<int>(hit.nested[1]),
                static_cast<int>(hit.nested[2]), static_cast<int>(hit.nested[3]));
  return text;
}

std::string ToString(const Ray& ray) {
  char text[300];
  std::snprintf(text, sizeof text,
                "origin %.9g %.9g %.9g direction %.9g %.9g %.9g t %.9g to %.9g time %.9g mask %x",
                static_cast<double>(ray.origin.x), static_cast<double>(ray.origin.y),
                static_cast<double>(ray.origin.z), static_cast<double>(ray.direction.x),
                static_cast<double>(ray.direction.y), static_cast<double>(ray.direction.z),
                static_cast<double>(ray.t_min), static_cast<double>(ray.t_max),
                static_cast<double>(ray.time), ray.mask);
  return text;
}

std::string ToString(const BuildOptions& options) {
  if (options.accelerator != AcceleratorKind::kBvh) {
    return std::string(AcceleratorName(options.accelerator));
  }
  return std::string(IsaName(options.isa)) +
         (options.quality == BuildQuality::kFast ? " fast" : " best") +
         (options.width == 16 ? ", nodes of 16" : "");
}

std::string ToString(Entry entry) {
  return entry == Entry::kOneByOne    ? "one by one"
         : entry == Entry::kScattered ? "scattered"
                                      : "coherent";
}

}  // namespace candela::test
