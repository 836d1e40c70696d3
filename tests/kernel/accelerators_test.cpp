// What is special about grid and octree; that they find what a search without a structure finds is
// said by the tests of all builds.
#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "kernel/accelerators/accelerator.h"
#include "kernel/accelerators/octree.h"
#include "kernel/accelerators/uniform_grid.h"
#include "tests/kernel/group_description.h"
#include "tests/kernel/trace_lists.h"

namespace candela::test {
namespace {

BuildOptions With(AcceleratorKind accelerator) {
  BuildOptions options;
  options.accelerator = accelerator;
  return options;
}

const kernel::UniformGrid& GridOf(const Group& group) {
  return dynamic_cast<const kernel::UniformGrid&>(*group.data().structure);
}

const kernel::Octree& OctreeOf(const Group& group) {
  return dynamic_cast<const kernel::Octree&>(*group.data().structure);
}

TEST(Accelerators, HaveNamesByWhichTheyAreFound) {
  for (const AcceleratorEntry& entry : Accelerators()) {
    ASSERT_NE(FindAccelerator(entry.name), nullptr);
    EXPECT_EQ(FindAccelerator(entry.name)->kind, entry.kind);
    EXPECT_EQ(AcceleratorName(entry.kind), entry.name);
  }
  EXPECT_EQ(FindAccelerator("kdtree"), nullptr);
}

TEST(UniformGrid, HasCellsByTheShapeOfTheBox) {
  const TestMesh globe = Globe(40, 50);
  const auto round = MustBuild(OfMesh(globe), With(AcceleratorKind::kGrid));
  EXPECT_GT(GridOf(*round).CellCount(0), 10);
  EXPECT_EQ(GridOf(*round).CellCount(0), GridOf(*round).CellCount(1));
  const auto flat = MustBuild(OfMesh(CurvedGrid(50, 0)), With(AcceleratorKind::kGrid));
  EXPECT_GT(GridOf(*flat).CellCount(0), 40);
  EXPECT_EQ(GridOf(*flat).CellCount(1), 1);  // It lies across y.
}

TEST(Octree, GoesDeeperWhereMuchIs) {
  TestMesh mesh = Globe(40, 50);
  const auto even = MustBuild(OfMesh(mesh), With(AcceleratorKind::kOctree));
  const auto uneven = MustBuild(OfMesh(Join({Moved(mesh, 0.001f, {0, 0, 0}), mesh})),
                                With(AcceleratorKind::kOctree));
  EXPECT_GT(OctreeOf(*even).Depth(), 3);
  EXPECT_GT(OctreeOf(*uneven).Depth(), OctreeOf(*even).Depth() + 4);
  EXPECT_LE(OctreeOf(*uneven).Depth(), kernel::Octree::kMostDepth);
}

/// Squares across z around the axis, in boxes without thickness.
class FlatSquares final : public PrimitiveSet {
 public:
  explicit FlatSquares(std::vector<float> heights) : heights_(std::move(heights)) {}

  uint32_t PrimitiveCount() const override { return static_cast<uint32_t>(heights_.size()); }
  Bounds3 PrimitiveBounds(uint32_t primitive, uint32_t) const override {
    return {{-1, -1, heights_[primitive]}, {1, 1, heights_[primitive]}};
  }
  bool IntersectPrimitive(const Ray& ray, uint32_t primitive, HitRecord* hit) const override {
    const float t = (heights_[primitive] - ray.origin.z) / ray.direction.z;
    if (!(t >= ray.t_min && t < hit->t)) return false;
    hit->t = t;
    return true;
  }

 private:
  const std::vector<float> heights_;
};

// Where rounding could leave a gap: at the outer side of the cube, and between two cells.
TEST(Octree, LosesNothingFlatBetweenItsCells) {
  for (const float nearest : {1e-20f, 6.123e-17f}) {
    std::vector<float> heights = {nearest};
    for (int i = 1; i <= 12; ++i) heights.push_back(static_cast<float>(-i));
    const FlatSquares squares(heights);
    GroupInput input(1);
    input[0].content = PrimitiveInput{&squares};
    const auto group = Group::Build(std::move(input), With(AcceleratorKind::kOctree));
    ASSERT_TRUE(group);
    HitRecord hit;
    ASSERT_TRUE((*group)->Intersect(Ray({0.25f, 0.25f, 5}, {0, 0, -1}), &hit));
    EXPECT_EQ(hit.primitive, 0u) << nearest;
  }
}

/// So many times the same triangle, moved by `step` each time.
TestMesh Repeated(uint32_t count, float size, Vec3 step) {
  TestMesh mesh;
  for (uint32_t i = 0; i < count; ++i) {
    const Vec3 corner = step * static_cast<float>(i);
    mesh.positions.insert(mesh.positions.end(),
                          {corner, corner + Vec3{size, 0, 0}, corner + Vec3{0, size, size}});
    mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  return mesh;
}

// What lies in the same place no cell can part. Of a copy of the mesh there are 48 bytes for each
// triangle, of its entry 8; then 4 for each time that it is listed, and the cells.
TEST(AcceleratorMemory, IsBoundedWhateverLiesWhere) {
  constexpr uint32_t kCount = 100'000;
  const TestMesh coincident = Repeated(kCount, 1, {});
  const TestMesh tiny_in_large = Join({Repeated(kCount, 1e-6f, {}), Repeated(1, 1e30f, {})});
  const TestMesh long_slivers = Repeated(kCount, 1, {0, 1e-5f, 0});
  for (const TestMesh* mesh : {&coincident, &tiny_in_large, &long_slivers}) {
    for (const AcceleratorEntry& entry : Accelerators()) {
      const auto group = MustBuild(OfMesh(*mesh), With(entry.kind));
      EXPECT_LE(group->MemoryBytes(), kCount * (48 + 8 + 8 + 4 * 32 + 4 * 16)) << entry.name;
    }
  }
}

// From so far away that the rounding of a ray is larger than what the cells allow for.
TEST(Accelerators, FindTheSameFromFarAway) {
  const GroupDescription description = OfMesh(Globe(30, 40));
  UniformNumbers random(5);
  std::vector<Ray> rays;
  for (float distance = 10; distance < 1e9f; distance *= 10) {
    for (int i = 0; i < 200; ++i) {
      const Vec3 origin = RandomPoint(&random) * distance;
      rays.emplace_back(origin, Normalize(RandomPoint(&random) * 1.5f - origin));
    }
  }
  const auto expected = IntersectList(*MustBuild(description, {}), Entry::kOneByOne, rays);
  size_t hits = 0;
  for (const HitRecord& hit : expected) hits += hit.IsHit();
  EXPECT_GT(hits, rays.size() / 10);
  for (const AcceleratorEntry& entry : Accelerators()) {
    const auto found =
        IntersectList(*MustBuild(description, With(entry.kind)), Entry::kOneByOne, rays);
    for (size_t i = 0; i < rays.size(); ++i) {
      ASSERT_TRUE(IsSame(found[i], expected[i])) << entry.name << ": " << ToString(rays[i]);
    }
  }
}

}  // namespace
}  // namespace candela::test
