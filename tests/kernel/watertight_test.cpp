// Nothing gets out of a closed mesh: rays from inside towards edges and vertices hit something.
//
// The usual set has 1e7 rays, the slow one 1e8, each of which goes one of the six ways through the
// kernel. Under sanitizers fewer rays go all six ways, or one of them where the search is scalar,
// which takes long.
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <vector>

#include "base/parallel.h"
#include "geometry/triangle.h"
#include "math/transform.h"
#include "tests/kernel/group_description.h"
#include "tests/kernel/trace_lists.h"
#include "tests/support/effort.h"

namespace candela::test {
namespace {

using testing_support::kIsSanitized;
using testing_support::kIsSlow;

constexpr int64_t kRays = kIsSlow ? 100'000'000 : kIsSanitized ? 50'000 : 10'000'000;
/// Under sanitizers the rays of a mesh are one list, which would go one way only.
constexpr bool kAllWays = kIsSanitized;

/// A closed mesh around the origin.
struct Shell {
  const char* name;
  TestMesh mesh;
  float inner_radius;  ///< Of a ball that it contains.
};

const std::vector<Shell>& Shells() {
  static const std::vector<Shell> shells = {
      {"sphere", Globe(200, 200), 0.99f},
      {"coarse sphere", Globe(15, 20), 0.9f},
      {"star", Star(60, 120, 12), 0.49f},
      {"slivers", Globe(3, 300, {100, 1, 0.01f}), 0.005f},
  };
  return shells;
}

/// A size and a place.
struct Placement {
  float scale, offset;

  Vec3 Center() const { return Vec3{1, -0.8f, 0.6f} * offset; }
  Mat4 Matrix() const {
    const double s = static_cast<double>(scale);
    return Mat4::Translate(ToDouble(Center())) * Mat4::Scale({s, s, s});
  }
  TestMesh Place(const Shell& shell) const { return Moved(shell.mesh, scale, Center()); }

  /// Whether rays can begin inside when positions are rounded there.
  bool HasInside(const Shell& shell) const {
    const float ulp = std::nextafter(offset, 1e30f) - offset;
    return shell.inner_radius * scale >= 7 * ulp;
  }
};

/// Triangles whose corners are three points of a line. Such a triangle is never hit, and the edge
/// on one side of it is not the two on the other, so that there is a gap between its neighbours.
size_t CountCollinear(const TestMesh& mesh) {
  size_t count = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    const Vec3 p = mesh.positions[a], q = mesh.positions[b], r = mesh.positions[c];
    const bool is_edge = p == q || q == r || r == p;  // Its neighbours fit together.
    count += !is_edge && TriangleCross(p, q, r) == Vec3d{};
  }
  return count;
}

constexpr Placement kPlacements[] = {{1e-3f, 0}, {1e-3f, 1e3f}, {1e-3f, 1.5e5f},
                                     {1, 0},     {1, 1e3f},     {1, 1.5e5f},
                                     {1e3f, 0},  {1e3f, 1e3f},  {1e3f, 1.5e5f}};
/// To build the meshes takes longest under sanitizers, where one place says as much as all.
std::span<const Placement> Placements() {
  return std::span(kPlacements).first(kIsSanitized ? 1 : std::size(kPlacements));
}

/// Shells and places that are tested; see the first two tests.
constexpr int kInstances = 30, kMeshes = 27;

std::string Name(const Shell& shell, const Placement& placement) {
  return std::string(shell.name) + " of size " + std::to_string(placement.scale) + " at " +
         std::to_string(placement.offset);
}

/// A ray from inside towards an edge, a vertex, or a float next to one of these.
Ray RandomRay(const Shell& shell, const TestMesh& mesh, const Placement& placement,
              UniformNumbers* random) {
  while (true) {
    const auto& triangle = mesh.triangles[RandomIndex(random, mesh.triangles.size())];
    const uint32_t corner = RandomIndex(random, 3);
    const Vec3 p = mesh.positions[triangle[corner]];
    const Vec3 q = mesh.positions[triangle[(corner + 1) % 3]];
    const uint32_t kind = RandomIndex(random, 4);
    Vec3 target = kind < 2 ? p + (q - p) * random->Next() : kind == 2 ? p : (p + q) * 0.5f;
    if (random->Next() < 0.3f) {
      const auto axis = static_cast<int>(RandomIndex(random, 3));
      target[axis] = std::nextafter(target[axis], random->Next() < 0.5f ? 1e30f : -1e30f);
    }
    const float reach = 0.1f * shell.inner_radius * placement.scale;
    const Vec3 origin = placement.Center() + RandomPoint(random) * reach;
    const Vec3 direction = target - origin;
    if (LengthSquared(direction) > 0) return Ray(origin, direction);
  }
}

/// Leaks of rays that were shot; the first one is told.
class Leaks {
 public:
  void Count(bool leaks, const Ray& ray, const std::string& how) {
    if (!leaks) return;
    if (count_++ > 0) return;
    const std::lock_guard lock(mutex_);
    first_ = how + ": " + ToString(ray);
  }
  void Expect(const std::string& where) const {
    EXPECT_EQ(count_, 0) << where << ", first " << first_;
  }

 private:
  std::atomic<int64_t> count_ = 0;
  std::mutex mutex_;
  std::string first_;
};

void ExpectTight(const Group& group, const Shell& shell, const TestMesh& mesh,
                 const Placement& placement, int64_t rays, const std::string& where) {
  constexpr int64_t kChunk = 2048;
  const bool all_ways = kAllWays && group.data().isa != Isa::kScalar;
  Leaks leaks;
  ParallelFor((rays + kChunk - 1) / kChunk, [&](int64_t chunk) {
    UniformNumbers random(static_cast<uint32_t>(chunk));
    std::vector<Ray> list;
    while (list.size() < kChunk) list.push_back(RandomRay(shell, mesh, placement, &random));
    for (int way = 0; way < 6; ++way) {
      if (!all_ways && way != chunk % 6) continue;
      const Entry entry = kEntries[way / 2];
      if (way % 2 == 0) {
        const auto hits = IntersectList(group, entry, list);
        for (size_t i = 0; i < list.size(); ++i) {
          leaks.Count(!hits[i].IsHit(), list[i], "Intersect " + ToString(entry));
        }
      } else {
        const auto occluded = OccludedList(group, entry, list);
        for (size_t i = 0; i < list.size(); ++i) {
          leaks.Count(occluded[i] == 0, list[i], "Occluded " + ToString(entry));
        }
      }
    }
  });
  leaks.Expect(where);
}

// The others are rounded to a handful of points or to a sheet without an inside: 1e-3 at 1.5e5,
// where floats are 0.016 apart, and slivers 0.01 thin wherever floats are farther apart than that.
TEST(Watertight, SixPlacementsLeaveNoInside) {
  int inside = 0;
  for (const Shell& shell : Shells()) {
    EXPECT_FALSE((Placement{1e-3f, 1.5e5f}.HasInside(shell))) << shell.name;
    for (const Placement& placement : kPlacements) inside += placement.HasInside(shell);
  }
  EXPECT_EQ(inside, kInstances);
  EXPECT_FALSE((Placement{1e-3f, 1e3f}.HasInside(Shells().back())));
  EXPECT_FALSE((Placement{1, 1.5e5f}.HasInside(Shells().back())));
}

// Rounded there, some triangles of these become points of a line.
TEST(Watertight, ThreeMeshesAreClosedNoMore) {
  int closed = 0;
  for (const Shell& shell : Shells()) {
    for (const Placement& placement : kPlacements) {
      closed += placement.HasInside(shell) && CountCollinear(placement.Place(shell)) == 0;
    }
  }
  EXPECT_EQ(closed, kMeshes);
  EXPECT_EQ(CountCollinear(Placement{1, 1.5e5f}.Place(Shells()[0])), 652u);
  EXPECT_EQ(CountCollinear(Placement{1, 1.5e5f}.Place(Shells()[2])), 2u);
  EXPECT_EQ(CountCollinear(Placement{1e-3f, 1e3f}.Place(Shells()[2])), 564u);
}

/// Without instructions for lanes, which takes long, a fifth of the rays that others get.
int64_t RaysOfOne(const BuildOptions& options) {
  const auto weight = [](const BuildOptions& of) { return of.isa == Isa::kScalar ? 1 : 5; };
  int64_t weights = 0;
  for (const BuildOptions& each : TreeBuildOptions()) weights += weight(each);
  return kRays * weight(options) / ((kInstances + kMeshes) * weights);
}

TEST(Watertight, ClosedMeshesAre) {
  for (const Shell& shell : Shells()) {
    for (const Placement& placement : Placements()) {
      const TestMesh mesh = placement.Place(shell);
      if (!placement.HasInside(shell) || CountCollinear(mesh) > 0) continue;
      for (const BuildOptions& options : TreeBuildOptions()) {
        const auto group = MustBuild(OfMesh(mesh), options);
        ExpectTight(*group, shell, mesh, placement, RaysOfOne(options),
                    Name(shell, placement) + ", " + ToString(options));
      }
    }
  }
}

TEST(Watertight, InstancesOfClosedMeshesAre) {
  for (const Shell& shell : Shells()) {
    for (const BuildOptions& options : TreeBuildOptions()) {
      const std::shared_ptr<const Group> inner = MustBuild(OfMesh(shell.mesh), options);
      for (const Placement& placement : Placements()) {
        if (!placement.HasInside(shell)) continue;
        GroupInput input(1);
        input[0].content = InstanceInput{inner, {placement.Matrix()}};
        auto group = Group::Build(std::move(input), options);
        ASSERT_TRUE(group.ok());
        const TestMesh mesh = Transformed(shell.mesh, placement.Matrix());
        ExpectTight(**group, shell, mesh, placement, RaysOfOne(options),
                    Name(shell, placement) + ", instance, " + ToString(options));
      }
    }
  }
}

}  // namespace
}  // namespace candela::test
