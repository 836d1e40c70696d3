// Geometry that nobody means to make: the tree stays shallow, and what is hit is what a search
// without a tree finds.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "tests/kernel/degenerate_scenes.h"
#include "tests/kernel/full_search.h"
#include "tests/kernel/sphere_set.h"
#include "tests/kernel/trace_lists.h"
#include "tests/support/effort.h"

namespace candela::test {
namespace {

constexpr float kLargest = std::numeric_limits<float>::max();
constexpr size_t kRays = testing_support::kIsSanitized ? 40 : 300;

/// Of a group's own items; those of groups inside have trees of their own.
struct Extent {
  uint64_t primitives = 0;
  float smallest = kLargest, largest = 0;  ///< Coordinates, by magnitude.

  void Add(Vec3 p) {
    for (int axis = 0; axis < 3; ++axis) {
      const float x = std::abs(p[axis]);
      if (!(x > 0 && x <= kLargest)) continue;
      smallest = std::min(smallest, x);
      largest = std::max(largest, x);
    }
  }
};

Extent ExtentOf(const GroupDescription& group) {
  Extent extent;
  for (const auto& item : group.items) {
    if (const auto* mesh = std::get_if<1>(&item.content)) {
      extent.primitives += (*mesh)->triangles.size();
      for (const Vec3 p : (*mesh)->positions) extent.Add(p);
    } else if (const auto* set = std::get_if<2>(&item.content)) {
      extent.primitives += (*set)->PrimitiveCount();
    } else if (std::get_if<3>(&item.content)) {
      extent.primitives += 1;
    }
  }
  return extent;
}

/// Rays of several sizes about the origin, some of them along axes, and some to vertices.
std::vector<Ray> RaysThrough(const GroupDescription& group, size_t count) {
  Extent extent = ExtentOf(group);
  if (extent.largest == 0) extent.smallest = extent.largest = 3;  // No triangles.
  UniformNumbers random(11);
  std::vector<Ray> rays;
  const TestMesh* mesh = nullptr;
  for (const auto& item : group.items) {
    if (const auto* some = std::get_if<1>(&item.content)) mesh = some->get();
  }
  if (mesh && mesh->positions.empty()) mesh = nullptr;
  while (rays.size() < count) {
    const float scales[] = {1, extent.smallest, extent.largest};
    const float scale = scales[RandomIndex(&random, 3)];
    // Twice as large would not always be a number.
    Vec3 origin = RandomPoint(&random) * std::min(scale, kLargest / 4) * 2;
    Vec3 target = RandomPoint(&random) * scale;
    if (mesh && rays.size() % 2 == 0) {
      target = mesh->positions[RandomIndex(&random, mesh->positions.size())];
    }
    Vec3 direction = target * 0.5f - origin * 0.5f;
    if (rays.size() % 5 == 0) {
      const auto axis = static_cast<int>(RandomIndex(&random, 3));
      direction = {};
      direction[axis] = random.Next() < 0.5f ? 1.0f : -1.0f;
      if (mesh) origin = target - direction * std::min(scale, kLargest / 4);
    }
    if (!(Length(ToDouble(direction)) > 0)) continue;
    rays.emplace_back(origin, NormalizeAnyLength(direction));
    rays.back().time = rays.size() % 4 == 0 ? 0.5f : random.Next();
  }
  return rays;
}

class Degenerate : public testing::TestWithParam<size_t> {};

TEST_P(Degenerate, GeometryMakesAShallowTreeWithTheRightAnswers) {
  const DegenerateScene& scene = DegenerateScenes()[GetParam()];
  const GroupDescription description = scene.make();
  const Extent extent = ExtentOf(description);
  const bool is_large = extent.primitives > 50'000;
  const std::vector<Ray> rays = RaysThrough(description, is_large ? 8 : kRays);
  std::vector<HitRecord> right(rays.size());
  const FullSearch search(description);
  for (size_t i = 0; i < rays.size(); ++i) search.Intersect(rays[i], &right[i]);

  for (const BuildOptions& options : AllBuildOptions()) {
    const auto group = MustBuild(description, options);
    const int log = std::bit_width(std::max<uint64_t>(extent.primitives, 1));
    EXPECT_LE(group->data().depth, 64 + log) << ToString(options);
    const Bounds3 bounds = group->Bounds();
    EXPECT_TRUE(bounds.IsEmpty() || bounds.IsFinite()) << ToString(options);

    for (const Entry entry : kEntries) {
      auto hits = IntersectList(*group, entry, rays);
      const auto occluded = OccludedList(*group, entry, rays);
      int wrong = 0;
      for (size_t i = 0; i < rays.size(); ++i) {
        const bool is_moved = scene.has_rays_in_plane && options.quality == BuildQuality::kBest;
        if (is_moved && hits[i].t > right[i].t && hits[i].t < right[i].t * 1.0001f) {
          hits[i].t = right[i].t;
        }
        const bool is_right =
            scene.is_too_large ||
            (IsSame(hits[i], right[i]) && occluded[i] == static_cast<uint8_t>(right[i].IsHit()));
        const bool is_finite =
            std::isfinite(hits[i].t) && std::isfinite(hits[i].u) && std::isfinite(hits[i].v);
        if ((is_right && is_finite) || ++wrong > 1) continue;
        ADD_FAILURE() << ToString(options) << ", " << ToString(entry) << ": " << ToString(rays[i])
                      << "\n  found " << ToString(hits[i]) << (occluded[i] ? " occluded" : "")
                      << "\n  right " << ToString(right[i]);
      }
      EXPECT_EQ(wrong, 0) << ToString(options) << ", " << ToString(entry);
    }
  }
}

std::string SceneName(const testing::TestParamInfo<size_t>& info) {
  std::string name = DegenerateScenes()[info.param].name;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}
INSTANTIATE_TEST_SUITE_P(Of, Degenerate, testing::Range(size_t{0}, DegenerateScenes().size()),
                         SceneName);

// A group of the deepest nesting that is allowed, and one level more.
TEST(Nesting, OfFiveLevelsWorksAndOneMoreIsAnError) {
  GroupDescription group = OfMesh(Globe(4, 4));
  for (int level = 0; level < HitRecord::kMostNested; ++level) {
    group = InstancesOf(std::move(group), {{Mat4::Identity()}});
    ASSERT_TRUE(Build(group, {}).ok()) << level;
  }
  HitRecord hit;
  EXPECT_TRUE(MustBuild(group, {})->Intersect(Ray({0, 0, 0}, {1, 2, 3}), &hit));
  EXPECT_EQ(hit.nested[HitRecord::kMostNested - 1], 0u);

  const auto too_deep = Build(InstancesOf(std::move(group), {{Mat4::Identity()}}), {});
  ASSERT_FALSE(too_deep.ok());
  EXPECT_EQ(too_deep.error().code, ErrorCode::kResources);
}

/// A group of an instance, which may be wrong.
ErrorCode ErrorOfInstance(const GroupItem& item, const BuildOptions& options = {}) {
  const auto group = Group::Build({item}, options);
  return group ? ErrorCode::kStopped : group.error().code;
}

TEST(Instances, ThatCannotBeAreErrors) {
  const std::shared_ptr<const Group> inner = MustBuild(OfMesh(Globe(4, 4)), {});
  const Mat4 flat = Mat4::Scale({1, 0, 1});
  EXPECT_EQ(ErrorOfInstance({InstanceInput{inner, {}}}), ErrorCode::kUsage);
  EXPECT_EQ(ErrorOfInstance({InstanceInput{inner, {flat}}}), ErrorCode::kUsage);
  EXPECT_EQ(ErrorOfInstance({InstanceInput{inner, {flat, Mat4::Identity()}}}), ErrorCode::kUsage);

  GroupItem item{InstanceInput{inner, {Mat4::Identity()}}};
  ASSERT_TRUE(Group::Build({item}, {}).ok());
  struct All final : HitFilter {
    bool Accepts(const Ray&, const HitRecord&) const override { return true; }
  } const all;
  item.filter = &all;
  EXPECT_EQ(ErrorOfInstance(item), ErrorCode::kUsage);
}

/// As many instances of a group without bounds.
Result<std::unique_ptr<Group>> UnboundedInstances(size_t count) {
  static const GroundSet kGround(-1);
  auto inner = Group::Build({{PrimitiveInput{&kGround}}}, {});
  const std::shared_ptr<const Group> shared = *std::move(inner);
  GroupInput input(count, GroupItem{InstanceInput{shared, {Mat4::Identity()}}});
  return Group::Build(std::move(input), {});
}

TEST(Instances, WithoutBoundsStandOnTheStackTogetherUpToALimit) {
  const auto some = UnboundedInstances(500);
  ASSERT_TRUE(some.ok());
  const Ray ray({0, 0, 0}, {0.5f, -1, 0.25f});
  for (const Entry entry : kEntries) {
    const auto hits = IntersectList(**some, entry, std::vector<Ray>(20, ray));
    for (const HitRecord& hit : hits) EXPECT_EQ(hit.object, 0u) << ToString(entry);
  }
  const auto too_many = UnboundedInstances(2000);
  ASSERT_FALSE(too_many.ok());
  EXPECT_EQ(too_many.error().code, ErrorCode::kResources);
}

TEST(Meshes, WithoutATimeStepAreErrors) {
  const TestMesh mesh = Globe(4, 4);
  const auto group = Group::Build({{TriangleInput{mesh.positions, mesh.triangles, 0}}}, {});
  ASSERT_FALSE(group.ok());
  EXPECT_EQ(group.error().code, ErrorCode::kUsage);
}

TEST(Instances, CannotBeRefittedToAMatrixWithoutAnInverse) {
  const std::shared_ptr<const Group> inner = MustBuild(OfMesh(Globe(4, 4)), {});
  auto group = Group::Build({{InstanceInput{inner, {Mat4::Identity()}}}}, {});
  ASSERT_TRUE(group.ok());
  const auto refitted = (*group)->Refit({{InstanceInput{inner, {Mat4::Scale({1, 0, 1})}}}});
  ASSERT_FALSE(refitted.ok());
  EXPECT_EQ(refitted.error().code, ErrorCode::kUsage);
  HitRecord hit;
  EXPECT_TRUE((*group)->Intersect(Ray({0, 0, 0}, {1, 2, 3}), &hit));
}

TEST(Instances, OfAGroupWithNodesOfAnotherWidthAreErrors) {
  if (!IsSupported(Isa::kAvx512)) GTEST_SKIP() << "nodes of 16 need AVX-512";
  BuildOptions wide;
  wide.isa = Isa::kAvx512;
  wide.width = 16;
  const std::shared_ptr<const Group> inner = MustBuild(OfMesh(Globe(4, 4)), wide);
  const GroupItem item{InstanceInput{inner, {Mat4::Identity()}}};
  EXPECT_TRUE(Group::Build({item}, wide).ok());
  EXPECT_EQ(ErrorOfInstance(item), ErrorCode::kUsage);
}

TEST(Instances, OfAGroupWithAnotherAcceleratorAreErrors) {
  BuildOptions grid;
  grid.accelerator = AcceleratorKind::kGrid;
  const std::shared_ptr<const Group> inner = MustBuild(OfMesh(Globe(4, 4)), grid);
  const GroupItem item{InstanceInput{inner, {Mat4::Identity()}}};
  EXPECT_TRUE(Group::Build({item}, grid).ok());
  EXPECT_EQ(ErrorOfInstance(item), ErrorCode::kUsage);
}

}  // namespace
}  // namespace candela::test
