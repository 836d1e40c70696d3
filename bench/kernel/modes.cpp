#include "modes.h"
#include "support/cpu_seconds.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace candela {
namespace {

/// Rays that a renderer would hand over together.
constexpr size_t kSpan = 2048;

void Start(std::span<const Ray> rays, std::span<HitRecord> hits) {
  for (size_t i = 0; i < rays.size(); ++i) {
    hits[i] = HitRecord();
    hits[i].t = rays[i].t_max;
  }
}

/// Calls `body` for each part of the rays.
template <class Body>
void ForSpans(std::span<const Ray> rays, const Body& body) {
  for (size_t begin = 0; begin < rays.size(); begin += kSpan) {
    body(begin, rays.subspan(begin, std::min(kSpan, rays.size() - begin)));
  }
}

double TimeOnce(const Tracer& tracer, std::span<const Ray> rays, bool any_hit) {
  std::vector<HitRecord> hits(kSpan);
  std::vector<uint8_t> occluded(kSpan);
  const double before = CpuSeconds();
  ForSpans(rays, [&](size_t, std::span<const Ray> part) {
    if (any_hit) {
      tracer.occluded(part, std::span(occluded).first(part.size()));
    } else {
      const auto part_hits = std::span(hits).first(part.size());
      Start(part, part_hits);
      tracer.intersect(part, part_hits);
    }
  });
  return CpuSeconds() - before;
}

/// All answers; any hits as records with nothing but the object set.
std::vector<HitRecord> AllHits(const Tracer& tracer, std::span<const Ray> rays, bool any_hit) {
  std::vector<HitRecord> hits(rays.size());
  Start(rays, hits);
  std::vector<uint8_t> occluded(kSpan);
  ForSpans(rays, [&](size_t begin, std::span<const Ray> part) {
    if (!any_hit) return tracer.intersect(part, std::span(hits).subspan(begin, part.size()));
    tracer.occluded(part, std::span(occluded).first(part.size()));
    for (size_t i = 0; i < part.size(); ++i) {
      if (occluded[i] != 0) hits[begin + i].object = 0;
    }
  });
  return hits;
}

/// How far apart t may be. Taking a ray into an instance rounds its origin, which shows where the
/// way to the hit is short.
float Tolerance(const Ray& ray, const HitRecord& hit) {
  const float relative = 1e-4f * hit.t;
  if (hit.nested[0] == HitRecord::kNone) return relative;
  const Vec3 size = Abs(ray.origin);
  return relative + 1e-6f * std::max({size.x, size.y, size.z}) / Length(ray.direction);
}

Differences Compare(std::span<const Ray> rays, std::span<const HitRecord> hits,
                    std::span<const HitRecord> right) {
  Differences differences;
  for (size_t i = 0; i < hits.size(); ++i) {
    if (hits[i].IsHit() != right[i].IsHit()) {
      ++differences.hit_or_miss;
    } else if (hits[i].IsHit() && std::abs(hits[i].t - right[i].t) > Tolerance(rays[i], right[i])) {
      ++differences.t;
    }
  }
  return differences;
}

/// Records that are not the same bits.
uint64_t CountOthers(std::span<const HitRecord> hits, std::span<const HitRecord> right) {
  uint64_t count = 0;
  for (size_t i = 0; i < hits.size(); ++i) {
    const HitRecord &a = hits[i], &b = right[i];
    const bool same = a.t == b.t && a.u == b.u && a.v == b.v && a.object == b.object &&
                      a.primitive == b.primitive && std::ranges::equal(a.nested, b.nested);
    if (!same) ++count;
  }
  return count;
}

}  // namespace

std::array<double, kModes> TimeModes(const Tracers& tracers, std::span<const Ray> rays,
                                     bool any_hit, int repetitions) {
  std::array<double, kModes> best;
  best.fill(std::numeric_limits<double>::infinity());
  for (int repetition = 0; repetition < repetitions; ++repetition) {
    for (size_t mode = 0; mode < kModes; ++mode) {
      best[mode] = std::min(best[mode], TimeOnce(tracers[mode], rays, any_hit));
    }
  }
  return best;
}

Agreement CompareModes(const Tracers& tracers, std::span<const Ray> rays, bool any_hit) {
  const std::vector<HitRecord> right = AllHits(tracers[kEmbreeRobust], rays, any_hit);
  const std::vector<HitRecord> single = AllHits(tracers[kOurSingle], rays, any_hit);
  Agreement agreement;
  for (size_t mode = 0; mode < kModes; ++mode) {
    const std::vector<HitRecord> hits = AllHits(tracers[mode], rays, any_hit);
    agreement.from_robust[mode] = Compare(rays, hits, right);
    if (mode == kOurBatch) agreement.batch_from_single = CountOthers(hits, single);
    if (mode == kOurPacket) agreement.packet_from_single = CountOthers(hits, single);
  }
  return agreement;
}

}  // namespace candela
