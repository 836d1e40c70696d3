// The tree finds what a search without one finds, bit for bit, on every way through the kernel.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "tests/kernel/full_search.h"
#include "tests/kernel/random_group.h"
#include "tests/kernel/trace_lists.h"
#include "tests/support/effort.h"

namespace candela::test {
namespace {

using testing_support::kIsSanitized;
using testing_support::kIsSlow;

constexpr int kGroups = kIsSanitized ? 24 : 200;
constexpr size_t kRaysOfGroup = kIsSlow ? 50'000 : 500;

/// All rays go all six ways, or each sixth of them another.
enum class Ways { kAll, kOneEach };

/// Compares what is said of rays with what is right. Returns the number of wrong answers, the first
/// of which is told.
int ExpectAnswers(const Group& group, std::span<const Ray> rays, std::span<const HitRecord> right,
                  Ways ways, const std::string& where) {
  int wrong = 0;
  const auto count_wrong = [&](size_t i, const std::string& how, const std::string& found) {
    if (++wrong > 1) return;
    ADD_FAILURE() << where << ", " << how << ", ray " << i << ": " << ToString(rays[i])
                  << "\n  found " << found << "\n  right " << ToString(right[i]);
  };
  for (size_t way = 0; way < 6; ++way) {
    const Entry entry = kEntries[way / 2];
    const size_t begin = ways == Ways::kAll ? 0 : rays.size() * way / 6;
    const size_t end = ways == Ways::kAll ? rays.size() : rays.size() * (way + 1) / 6;
    const auto asked = rays.subspan(begin, end - begin);
    if (way % 2 == 0) {
      const std::vector<HitRecord> hits = IntersectList(group, entry, asked);
      for (size_t i = begin; i < end; ++i) {
        const HitRecord& hit = hits[i - begin];
        if (!IsSame(hit, right[i])) count_wrong(i, ToString(entry), ToString(hit));
      }
    } else {
      const std::vector<uint8_t> occluded = OccludedList(group, entry, asked);
      for (size_t i = begin; i < end; ++i) {
        const uint8_t found = occluded[i - begin];
        if (found != static_cast<uint8_t>(right[i].IsHit())) {
          count_wrong(i, ToString(entry), "occluded " + std::to_string(found));
        }
      }
    }
  }
  return wrong;
}

std::vector<HitRecord> RightAnswers(const GroupDescription& group, std::span<const Ray> rays) {
  const FullSearch search(group);
  std::vector<HitRecord> right(rays.size());
  for (size_t i = 0; i < rays.size(); ++i) {
    right[i].t = rays[i].t_max;
    search.Intersect(rays[i], &right[i]);
  }
  return right;
}

/// Without the tree all ways to ask are one, and slow.
size_t MostRays(AcceleratorKind accelerator) {
  switch (accelerator) {
    case AcceleratorKind::kBvh:
      return kRaysOfGroup;
    case AcceleratorKind::kNone:
      return 8;
    default:
      return 50;
  }
}

class RandomGroups : public testing::TestWithParam<int> {};

// Nearest hits, their weights and all indices, and occlusion: 1e5 rays in 200 groups, each asked
// one by one, scattered and coherent, for every instruction set and both qualities; a part of them
// with the other accelerators. The slow set has 1e7, each of which is asked for in one of these
// ways.
TEST_P(RandomGroups, AnswerLikeASearchWithoutATree) {
  const auto kind = static_cast<GroupKind>(GetParam());
  int wrong = 0, hits = 0;
  for (int i = 0; i < kGroups / kGroupKinds; ++i) {
    UniformNumbers random(static_cast<uint32_t>(1000 * GetParam() + i));
    const GroupDescription group = RandomGroup(kind, &random);
    const std::vector<Ray> rays = RandomRays(group, kRaysOfGroup, &random);
    const std::vector<HitRecord> right = RightAnswers(group, rays);
    for (const HitRecord& hit : right) hits += hit.IsHit();
    for (const BuildOptions& options : AllBuildOptions()) {
      const size_t count = std::min(rays.size(), MostRays(options.accelerator));
      wrong += ExpectAnswers(*MustBuild(group, options), std::span(rays).first(count),
                             std::span(right).first(count), kIsSlow ? Ways::kOneEach : Ways::kAll,
                             "group " + std::to_string(i) + ", " + ToString(options));
    }
  }
  EXPECT_EQ(wrong, 0);
  EXPECT_GT(hits, kGroups / kGroupKinds * static_cast<int>(kRaysOfGroup / 10));
}

std::string KindName(const testing::TestParamInfo<int>& info) {
  constexpr const char* kNames[kGroupKinds] = {"Soup",    "Meshes",    "Mixed",  "Boxes",
                                               "Spheres", "Instances", "Moving", "Everything"};
  return kNames[info.param];
}
INSTANTIATE_TEST_SUITE_P(Of, RandomGroups, testing::Range(0, kGroupKinds), KindName);

// Rays go through in packets of 16 and in 32 slots: lists shorter than these, and just longer.
TEST(RayLists, OfAnyLengthAnswerLikeSingleRays) {
  UniformNumbers random(7);
  const GroupDescription description = RandomGroup(GroupKind::kEverything, &random);
  const std::vector<Ray> rays = RandomRays(description, 1000, &random);
  for (const BuildOptions& options : AllBuildOptions()) {
    const auto group = MustBuild(description, options);
    const std::vector<HitRecord> hits = IntersectList(*group, Entry::kOneByOne, rays);
    for (const size_t count : {0u, 1u, 2u, 15u, 16u, 17u, 31u, 32u, 33u, 1000u}) {
      const std::string where = ToString(options) + ", " + std::to_string(count) + " rays";
      EXPECT_EQ(ExpectAnswers(*group, std::span(rays).first(count), std::span(hits).first(count),
                              Ways::kAll, where),
                0);
    }
  }
}

// The box of a leaf is entered before its triangles are: the distance is that of the triangle.
TEST(Ties, AtTheSameDistanceTheSmallestPathWins) {
  const TestMesh square = CurvedGrid(1, 0);
  GroupDescription inner = OfMesh(square);
  inner.items.push_back(inner.items[0]);
  const auto shared = std::make_shared<GroupDescription>(inner);
  const GroupDescription::Item instance{GroupDescription::Instance{shared, {Mat4::Identity()}},
                                        kAnyRay, nullptr};
  GroupDescription group;
  group.items.emplace_back();  // 0 is free,
  group.items.push_back(instance);
  group.Add(square);  // and 1, 2 and 3 coincide.
  group.items.push_back(instance);

  const Ray ray({0.5f, 1, 0.25f}, {0, -1, 0});
  for (const BuildOptions& options : AllBuildOptions()) {
    HitRecord hit;
    ASSERT_TRUE(MustBuild(group, options)->Intersect(ray, &hit)) << ToString(options);
    EXPECT_EQ(hit.t, 1.0f);
    EXPECT_EQ(hit.object, 1u) << ToString(options);
    EXPECT_EQ(hit.nested[0], 0u) << ToString(options);

    GroupDescription without = group;
    without.items[1] = {};
    HitRecord second;
    ASSERT_TRUE(MustBuild(without, options)->Intersect(ray, &second)) << ToString(options);
    EXPECT_EQ(second.object, 2u) << ToString(options);
    EXPECT_EQ(second.nested[0], HitRecord::kNone) << ToString(options);
  }
}

}  // namespace
}  // namespace candela::test
