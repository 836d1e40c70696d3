#include "kernel/build_group.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

#include "base/parallel.h"
#include "tests/kernel/tree_check.h"
#include "tests/sampling/chi_square.h"

namespace candela::kernel {
namespace {

using test::UniformNumbers;
using testing_support::TreeCheck;

struct Mesh {
  std::vector<Vec3> positions;
  std::vector<std::array<uint32_t, 3>> triangles;
  uint32_t steps = 1;

  GroupItem Item() const { return {TriangleInput{positions, triangles, steps}}; }
};

/// A height field of `size` times `size` squares of two triangles.
Mesh Terrain(uint32_t size) {
  Mesh mesh;
  UniformNumbers random(1);
  for (uint32_t y = 0; y <= size; ++y) {
    for (uint32_t x = 0; x <= size; ++x) {
      mesh.positions.push_back({static_cast<float>(x), static_cast<float>(y), random.Next()});
    }
  }
  for (uint32_t y = 0; y < size; ++y) {
    for (uint32_t x = 0; x < size; ++x) {
      const uint32_t v = y * (size + 1) + x;
      mesh.triangles.push_back({v, v + 1, v + size + 2});
      mesh.triangles.push_back({v, v + size + 2, v + size + 1});
    }
  }
  return mesh;
}

Vec3 RandomPoint(UniformNumbers* random) {
  const Vec2 xy = random->NextPair();
  return {2 * xy.x - 1, 2 * xy.y - 1, 2 * random->Next() - 1};
}

/// Triangles of very different sizes, without shared vertices.
Mesh Soup(uint32_t count, float scale) {
  Mesh mesh;
  UniformNumbers random(2);
  for (uint32_t i = 0; i < count; ++i) {
    const Vec3 center = RandomPoint(&random);
    const float u = random.Next();
    for (int corner = 0; corner < 3; ++corner) {
      mesh.positions.push_back((center + RandomPoint(&random) * std::max(0.01f, u * u)) * scale);
    }
    mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  return mesh;
}

struct Variant {
  BuildQuality quality;
  int width;
};
class BuildGroupOf : public testing::TestWithParam<Variant> {
 protected:
  GroupData Build(const GroupInput& input) const {
    Result<GroupData> group = BuildGroup(input, GetParam().quality, GetParam().width, nullptr);
    EXPECT_TRUE(group.ok());
    return std::move(*group);
  }
  bool Splits() const { return GetParam().quality == BuildQuality::kBest; }

  /// The tree is right, and has these triangles of item 0.
  void ExpectTree(const GroupInput& input, const std::vector<uint32_t>& triangles) const {
    const GroupData group = Build(input);
    const TreeCheck check(input, group, !Splits());
    EXPECT_EQ(check.Problems(), "");
    EXPECT_EQ(check.Found().size(), triangles.size());
    for (const uint32_t i : triangles) {
      const auto found = check.Found().find({0, i});
      ASSERT_NE(found, check.Found().end()) << i;
      EXPECT_LE(found->second, Splits() ? 1000 : 1) << i;
    }
  }
  void ExpectTreeOfAll(const Mesh& mesh) const {
    std::vector<uint32_t> all(mesh.triangles.size());
    for (uint32_t i = 0; i < all.size(); ++i) all[i] = i;
    ExpectTree({mesh.Item()}, all);
  }
};

TEST_P(BuildGroupOf, NothingHasNoRoot) {
  const GroupData group = Build({});
  EXPECT_EQ(group.root, GroupData::kNothing);
  EXPECT_TRUE(group.bounds.IsEmpty());
  EXPECT_EQ(group.stack_need, 0u);
}

TEST_P(BuildGroupOf, OneTriangleIsALeafAtTheRoot) {
  const Mesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
  const GroupInput input = {mesh.Item()};
  const GroupData group = Build(input);
  EXPECT_EQ(group.root, MakeReference(RecordKind::kTriangles, 0));
  EXPECT_EQ(group.depth, 0);
  EXPECT_EQ(TreeCheck(input, group, true).Problems(), "");
}

TEST_P(BuildGroupOf, TerrainSharesVertices) {
  const Mesh mesh = Terrain(100);
  ExpectTreeOfAll(mesh);
  const GroupInput input = {mesh.Item()};
  const GroupData group = Build(input);
  const TreeCheck check(input, group, false);
  EXPECT_LT(check.TriangleLeaves() * 4, mesh.triangles.size());
}

// The same corners again for each triangle: they are found by their position.
TEST_P(BuildGroupOf, TrianglesWithoutSharedVerticesArePackedAsWell) {
  const Mesh shared = Terrain(20);
  Mesh mesh;
  for (const auto& triangle : shared.triangles) {
    const auto first = static_cast<uint32_t>(mesh.positions.size());
    for (const uint32_t vertex : triangle) mesh.positions.push_back(shared.positions[vertex]);
    mesh.triangles.push_back({first, first + 1, first + 2});
  }
  const GroupInput a = {shared.Item()}, b = {mesh.Item()};
  EXPECT_EQ(TreeCheck(a, Build(a), false).Leaves(), TreeCheck(b, Build(b), false).Leaves());
}

TEST_P(BuildGroupOf, TrianglesOfAllSizes) {
  ExpectTreeOfAll(Soup(3000, 1));
}

TEST_P(BuildGroupOf, CoordinatesOfAllSizes) {
  for (const float scale : {0x1p-100f, 0x1p-66f, 0x1p66f, 0x1p100f, 0x1p126f}) {
    SCOPED_TRACE(scale);
    ExpectTreeOfAll(Soup(1000, scale));
  }
}

TEST_P(BuildGroupOf, ManyCoincidentTriangles) {
  Mesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {}};
  mesh.triangles.assign(100'000, {0, 1, 2});
  ExpectTreeOfAll(mesh);
}

TEST_P(BuildGroupOf, ExponentiallySpacedTriangles) {
  Mesh mesh;
  for (int repeat = 0; repeat < 20; ++repeat) {
    for (int exponent = -120; exponent < 127; ++exponent) {
      const float x = std::ldexp(1.0f, exponent);
      const auto first = static_cast<uint32_t>(mesh.positions.size());
      mesh.positions.insert(mesh.positions.end(), {{x, 0, 0}, {x * 1.25f, 1, 0}, {x, 0, 1}});
      mesh.triangles.push_back({first, first + 1, first + 2});
    }
  }
  ExpectTreeOfAll(mesh);
}

TEST_P(BuildGroupOf, TrianglesThatAreNeverHitAreLeftOut) {
  const float inf = Bounds3::kInfinity, nan = std::numeric_limits<float>::quiet_NaN();
  const Mesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 0, 0}, {inf, 0, 0}, {0, nan, 0}},
                  {{0, 0, 1}, {0, 1, 2}, {0, 1, 3}, {0, 1, 4}, {5, 1, 0}, {1, 3, 2}}};
  ExpectTree({mesh.Item()}, {1, 5});
}

bool SameBytes(const GroupData& a, const GroupData& b) {
  return a.records.size() == b.records.size() && a.triangle_ids == b.triangle_ids &&
         a.root == b.root && a.bounds == b.bounds &&
         std::memcmp(a.records.data(), b.records.data(), a.records.size() * sizeof(Record)) == 0;
}

TEST_P(BuildGroupOf, TheSameBytesForAnyNumberOfThreads) {
  for (const Mesh& mesh : {Terrain(200), Soup(50'000, 1)}) {
    std::vector<GroupData> groups;
    for (const int threads : {1, 2, 7}) {
      const ThreadLimit limit(threads);
      groups.push_back(Build({mesh.Item()}));
    }
    for (const GroupData& other : {std::cref(groups[1]), std::cref(groups[2])}) {
      EXPECT_TRUE(SameBytes(groups[0], other));
    }
  }
}

/// Boxes on a line; number 3 of 7 is unbounded, number 5 is empty.
class BoxSet : public PrimitiveSet {
 public:
  BoxSet(uint32_t count, uint32_t steps) : count_(count), steps_(steps) {}
  uint32_t PrimitiveCount() const override { return count_; }
  uint32_t TimeSteps() const override { return steps_; }
  Bounds3 PrimitiveBounds(uint32_t primitive, uint32_t step) const override {
    if (primitive % 7 == 3) return Bounds3::Infinite();
    if (primitive % 7 == 5) return {};
    const auto x = static_cast<float>(primitive), y = static_cast<float>(step * step);
    return {{x, y, 0}, {x + 0.5f, y + 1, 1 + y}};
  }
  bool IntersectPrimitive(const Ray&, uint32_t, HitRecord*) const override { return false; }

 private:
  const uint32_t count_, steps_;
};

TEST_P(BuildGroupOf, PrimitivesWithBoxesAndWithout) {
  const BoxSet resting(700, 1), moving(700, 4);
  const GroupInput input = {{PrimitiveInput{&resting}}, {}, {PrimitiveInput{&moving}}};
  const GroupData group = Build(input);
  const TreeCheck check(input, group, true);
  EXPECT_EQ(check.Problems(), "");
  EXPECT_EQ(check.Found().size(), 1000u);
  EXPECT_EQ(group.unbounded.size(), (200 + 14) / 15u);
  EXPECT_EQ(KindOf(group.root), RecordKind::kNode);
}

TEST_P(BuildGroupOf, RestingAndMovingTriangles) {
  const Mesh resting = Terrain(20);
  Mesh moving = Terrain(30);
  const std::vector<Vec3> start = moving.positions;
  UniformNumbers random(5);
  for (moving.steps = 1; moving.steps < 4; ++moving.steps) {
    for (const Vec3 p : start) {
      moving.positions.push_back(p + RandomPoint(&random) +
                                 Vec3{1, 2, 3} * static_cast<float>(moving.steps * moving.steps));
    }
  }
  for (const GroupInput& input :
       {GroupInput{moving.Item()}, GroupInput{resting.Item(), moving.Item()}}) {
    const GroupData group = Build(input);
    const TreeCheck check(input, group, !Splits());
    EXPECT_EQ(check.Problems(), "");
    EXPECT_EQ(check.Found().size(), 1800u + (input.size() - 1) * 800);
  }
}

TEST_P(BuildGroupOf, MasksAndFiltersAreCheckedAndItemsDoNotShareLeaves) {
  const Mesh mesh = Terrain(20);
  GroupInput input = {mesh.Item(), mesh.Item(), mesh.Item()};
  input[1].mask = kShadowRay;
  const GroupData group = Build(input);
  const TreeCheck check(input, group, !Splits());
  EXPECT_EQ(check.Problems(), "");
  EXPECT_EQ(check.Found().size(), 3 * mesh.triangles.size());
}

TEST_P(BuildGroupOf, StopsWhenCancelled) {
  CancelToken cancel;
  cancel.Cancel();
  const Mesh mesh = Terrain(20);
  const auto result = BuildGroup({mesh.Item()}, GetParam().quality, GetParam().width, &cancel);
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.error().code, ErrorCode::kStopped);
}

TEST_P(BuildGroupOf, RefittingToTheSamePositionsChangesNothing) {
  const Mesh mesh = Terrain(50);
  const GroupInput input = {mesh.Item()};
  GroupData group = Build(input);
  const GroupData before = Build(input);
  ASSERT_TRUE(RefitGroup(input, &group).ok());
  EXPECT_TRUE(SameBytes(group, before));
}

TEST_P(BuildGroupOf, RefittingFollowsWhatMoves) {
  Mesh resting = Soup(2000, 1), moving = Terrain(20);
  moving.positions.insert(moving.positions.end(), moving.positions.begin(), moving.positions.end());
  moving.steps = 2;
  const BoxSet boxes(50, 1);
  const GroupInput input = {resting.Item(), moving.Item(), {PrimitiveInput{&boxes}}};
  GroupData group = Build(input);
  UniformNumbers random(7);
  for (Mesh* mesh : {&resting, &moving}) {
    for (Vec3& p : mesh->positions) p = p * 2 + RandomPoint(&random) * 0.1f;
  }
  ASSERT_TRUE(RefitGroup(input, &group).ok());
  const TreeCheck check(input, group, true);
  EXPECT_EQ(check.Problems(), "");
  EXPECT_EQ(check.Found().size(), 2800u + 36u);
}

// They were found to be the same vertex.
TEST_P(BuildGroupOf, RefittingFailsWhenVerticesOfTheSamePositionMoveApart) {
  Mesh mesh{{{0, 0, 0},
             {1, 0, 0},
             {0, 1, 0},
             {1, 0, 0},
             {0, 1, 0},
             {1, 1, 0},
             {1, 0, 0},
             {2, 0, 0},
             {1, 1, 0}},
            {{0, 1, 2}, {3, 4, 5}, {6, 7, 8}}};
  const GroupInput input = {mesh.Item()};
  GroupData group = Build(input);
  ASSERT_EQ(KindOf(group.root), RecordKind::kTriangles);
  for (Vec3& p : mesh.positions) p.z = 1;
  EXPECT_TRUE(RefitGroup(input, &group).ok());
  mesh.positions[6].z = 2;
  const Result<void> result = RefitGroup(input, &group);
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.error().code, ErrorCode::kUsage);
  EXPECT_LT(group.bounds.max.z, 1.5f);  // Nothing was changed.
}

TEST_P(BuildGroupOf, RefittingFailsForOtherItems) {
  const Mesh mesh = Terrain(10);
  const BoxSet boxes(50, 1);
  GroupData group = Build({mesh.Item()});
  EXPECT_FALSE(RefitGroup({}, &group).ok());
  EXPECT_FALSE(RefitGroup({{PrimitiveInput{&boxes}}}, &group).ok());
  EXPECT_FALSE(RefitGroup({Terrain(9).Item()}, &group).ok());
}

INSTANTIATE_TEST_SUITE_P(Variants, BuildGroupOf,
                         testing::Values(Variant{BuildQuality::kFast, 8},
                                         Variant{BuildQuality::kFast, 16},
                                         Variant{BuildQuality::kBest, 8},
                                         Variant{BuildQuality::kBest, 16}));

TEST(BuildGroup, LeavesDoNotDependOnTheWidthOfNodes) {
  for (const BuildQuality quality : {BuildQuality::kFast, BuildQuality::kBest}) {
    for (const Mesh& mesh : {Terrain(100), Soup(5000, 1)}) {
      const GroupInput input = {mesh.Item()};
      const GroupData narrow = *BuildGroup(input, quality, 8, nullptr);
      const GroupData wide = *BuildGroup(input, quality, 16, nullptr);
      const TreeCheck a(input, narrow, false), b(input, wide, false);
      EXPECT_EQ(a.Leaves(), b.Leaves());
      EXPECT_LT(b.Nodes() * 10, a.Nodes() * 9);
    }
  }
}

}  // namespace
}  // namespace candela::kernel
