#include "measure.h"

#include <algorithm>
#include <limits>
#include <memory>

#include "base/clock.h"
#include "base/memory.h"
#include "base/parallel.h"
#include "our_group.h"
#include "support/cpu_seconds.h"

namespace candela {
namespace {

using Quality = EmbreeScene::Quality;

/// Best wall times; with one thread CPU times, which neighbours on the machine disturb less. In
/// each round every builder has its turn.
Result<std::array<double, kBuildModes>> TimeBuilds(const BenchScene& scene,
                                                   const EmbreeDevice& device, int rounds) {
  std::array<double, kBuildModes> best;
  best.fill(std::numeric_limits<double>::infinity());
  const auto measure = [&](BuildMode mode, const auto& build) -> Result<void> {
    const double cpu_before = CpuSeconds();
    const Stopwatch wall;
    const auto built = build();
    const double seconds = ThreadCount() == 1 ? CpuSeconds() - cpu_before : wall.Seconds();
    if (!built) return built.error();
    best[mode] = std::min(best[mode], seconds);
    return {};
  };
  const auto embree = [&](Quality quality) -> Result<std::unique_ptr<EmbreeScene>> {
    return std::make_unique<EmbreeScene>(device, scene, quality);
  };
  for (int round = 0; round < rounds; ++round) {
    for (const auto& timed : {
             measure(kBuildMedium, [&] { return embree(Quality::kMedium); }),
             measure(kBuildFast, [&] { return OurGroup::Build(scene, BuildQuality::kFast); }),
             measure(kBuildHigh, [&] { return embree(Quality::kHigh); }),
             measure(kBuildBest, [&] { return OurGroup::Build(scene, BuildQuality::kBest); }),
         }) {
      if (!timed) return timed.error();
    }
  }
  return best;
}

Tracer EmbreeSingle(const EmbreeScene& scene) {
  return {[&](auto rays, auto hits) { scene.Intersect(rays, hits); },
          [&](auto rays, auto occluded) { scene.Occluded(rays, occluded); }};
}

Tracer EmbreePackets(const EmbreeScene& scene) {
  return {[&](auto rays, auto hits) { scene.IntersectPackets(rays, hits); },
          [&](auto rays, auto occluded) { scene.OccludedPackets(rays, occluded); }};
}

Tracer OurSingle(const OurGroup& ours) {
  return {[&](auto rays, auto hits) { ours.Intersect(rays, hits); },
          [&](auto rays, auto occluded) { ours.Occluded(rays, occluded); }};
}

Tracer OurLists(const OurGroup& ours, RayOrder order) {
  return {[&, order](auto rays, auto hits) { ours.group().Intersect(order, rays, hits); },
          [&, order](auto rays, auto occluded) { ours.group().Occluded(order, rays, occluded); }};
}

}  // namespace

Result<SceneResult> MeasureScene(const BenchScene& scene, const EmbreeDevice& device,
                                 const MeasureOptions& options) {
  SceneResult result;
  result.name = scene.name;
  result.is_closed = scene.is_closed;
  result.triangles = scene.TriangleCount();
  result.built_triangles = scene.mesh.triangles.size() + scene.part.triangles.size();

  const Result<OurGroup> best = OurGroup::Build(scene, BuildQuality::kBest);
  if (!best) return best.error();
  result.peak_bytes = static_cast<double>(PeakMemory());
  // Single rays gain with nodes of 16, where the instruction set has them.
  const int single_width = DefaultIsa() == Isa::kAvx512 ? 16 : 8;
  const Result<OurGroup> single = OurGroup::Build(scene, BuildQuality::kBest, single_width);
  if (!single) return single.error();
  const Result<OurGroup> fast = OurGroup::Build(scene, BuildQuality::kFast, single_width);
  if (!fast) return fast.error();
  const EmbreeScene medium(device, scene, Quality::kMedium);
  const EmbreeScene high(device, scene, Quality::kHigh);
  const EmbreeScene robust(device, scene, Quality::kMedium, true);
  result.bytes = {static_cast<double>(medium.MemoryBytes()),
                  static_cast<double>(high.MemoryBytes()), static_cast<double>(fast->MemoryBytes()),
                  static_cast<double>(std::max(best->MemoryBytes(), single->MemoryBytes()))};

  const Tracers tracers = {EmbreeSingle(medium),
                           EmbreeSingle(high),
                           EmbreeSingle(robust),
                           EmbreePackets(medium),
                           OurSingle(*single),
                           OurLists(*best, RayOrder::kScattered),
                           OurLists(*best, RayOrder::kCoherent),
                           OurSingle(*fast)};
  for (const RaySet set : options.sets) {
    const Result<std::vector<Ray>> rays = MakeRays(set, scene, robust, options.side);
    if (!rays) return rays.error();
    const bool any_hit = set == RaySet::kShadow;
    const Agreement agreement = CompareModes(tracers, *rays, any_hit);
    const auto seconds = TimeModes(tracers, *rays, any_hit, options.repetitions);
    result.sets.push_back({set, rays->size(), seconds, agreement});
  }
  if (options.builds > 0) {
    const auto seconds = TimeBuilds(scene, device, options.builds);
    if (!seconds) return seconds.error();
    result.build_seconds = *seconds;
  }
  return result;
}

}  // namespace candela
