// Whichever allocation of a build fails, the build says so, and leaves nothing behind. This program
// has an `operator new` of its own, which fails when it is told to.
#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <limits>
#include <memory>
#include <new>
#include <utility>

#include "base/parallel.h"
#include "tests/kernel/group_description.h"
#include "tests/kernel/random_group.h"
#include "tests/kernel/sphere_set.h"
#include "tests/kernel/trace_lists.h"
#include "tests/support/effort.h"

namespace {

constexpr int64_t kNever = std::numeric_limits<int64_t>::max();

std::atomic<int64_t> live_blocks = 0;
std::atomic<int64_t> until_failure = kNever;   ///< The allocation that makes it 0 fails,
std::atomic<bool> fails_from_then_on = false;  ///< and those that follow.

void* Allocate(size_t bytes, size_t alignment) {
  if (until_failure != kNever) {
    const int64_t left = --until_failure;
    if (left == 0 || (left < 0 && fails_from_then_on)) return nullptr;
  }
  const size_t rounded = (bytes + alignment - 1) / alignment * alignment;
  void* const block = std::aligned_alloc(alignment, rounded > 0 ? rounded : alignment);
  if (block) ++live_blocks;
  return block;
}

void* AllocateOrThrow(size_t bytes, size_t alignment) {
  void* const block = Allocate(bytes, alignment);
  if (!block) throw std::bad_alloc();
  return block;
}

void Free(void* block) {
  if (block) --live_blocks;
  std::free(block);
}

constexpr size_t kUsual = alignof(std::max_align_t);

}  // namespace

void* operator new(size_t bytes) {
  return AllocateOrThrow(bytes, kUsual);
}
void* operator new[](size_t bytes) {
  return AllocateOrThrow(bytes, kUsual);
}
void* operator new(size_t bytes, std::align_val_t alignment) {
  return AllocateOrThrow(bytes, static_cast<size_t>(alignment));
}
void* operator new[](size_t bytes, std::align_val_t alignment) {
  return AllocateOrThrow(bytes, static_cast<size_t>(alignment));
}
void* operator new(size_t bytes, const std::nothrow_t&) noexcept {
  return Allocate(bytes, kUsual);
}
void* operator new[](size_t bytes, const std::nothrow_t&) noexcept {
  return Allocate(bytes, kUsual);
}
void operator delete(void* block) noexcept {
  Free(block);
}
void operator delete[](void* block) noexcept {
  Free(block);
}
void operator delete(void* block, size_t) noexcept {
  Free(block);
}
void operator delete[](void* block, size_t) noexcept {
  Free(block);
}
void operator delete(void* block, std::align_val_t) noexcept {
  Free(block);
}
void operator delete[](void* block, std::align_val_t) noexcept {
  Free(block);
}
void operator delete(void* block, size_t, std::align_val_t) noexcept {
  Free(block);
}
void operator delete[](void* block, size_t, std::align_val_t) noexcept {
  Free(block);
}
void operator delete(void* block, const std::nothrow_t&) noexcept {
  Free(block);
}
void operator delete[](void* block, const std::nothrow_t&) noexcept {
  Free(block);
}

namespace candela::test {
namespace {

/// Something of every kind, in a tree of several levels.
GroupDescription Everything() {
  UniformNumbers random(1);
  GroupDescription group;
  group.Add(Globe(testing_support::kIsSanitized ? 6 : 12, 16));
  group.Add(InMotion(Globe(6, 8), 3, 0.2f, &random));
  group.Add(Slivers(50, 0.01f, &random));
  std::vector<SphereSet::Sphere> spheres;
  for (int i = 0; i < 20; ++i) spheres.push_back({{RandomPoint(&random)}, 0.1f});
  group.items.push_back({std::make_shared<SphereSet>(spheres), kAnyRay, nullptr});
  group.items.push_back({std::make_shared<GroundSet>(-1.0f), kAnyRay, nullptr});
  const auto inner = std::make_shared<GroupDescription>(OfMesh(Globe(3, 4)));
  group.items.push_back(
      {GroupDescription::Instance{inner, {Mat4::Scale({2, 1, 1})}}, kAnyRay, nullptr});
  group.items.push_back(
      {GroupDescription::Instance{inner, {Mat4::Identity(), Mat4::Translate({1, 0, 0})}}, kAnyRay,
       nullptr});
  return group;
}

/// Lets each allocation of `work(input)` fail in turn until it succeeds; returns how many there
/// are.
template <class Work>
int64_t ExpectEachFailureIsTold(const GroupInput& input, Work work) {
  for (int64_t failing = 1; failing < 100000; ++failing) {
    const int64_t before = live_blocks;
    bool is_done = false;
    {
      GroupInput copy = input;
      until_failure = failing;
      const auto result = work(std::move(copy));
      const bool has_failed = until_failure <= 0;
      until_failure = kNever;
      is_done = result.ok();
      EXPECT_EQ(is_done, !has_failed) << "allocation " << failing;
      if (!is_done) {
        EXPECT_EQ(result.error().code, ErrorCode::kResources) << "allocation " << failing;
        EXPECT_EQ(result.error().message, "out of memory");
      }
    }
    EXPECT_EQ(live_blocks, before) << "allocation " << failing;
    if (is_done || testing::Test::HasFailure()) return failing - 1;
  }
  ADD_FAILURE() << "it never succeeds";
  return 0;
}

TEST(OutOfMemory, EachFailingAllocationOfABuildIsToldAndLeavesNothingBehind) {
  const ThreadLimit one_thread(1);  // With more, the threading library allocates as well.
  const GroupDescription description = Everything();
  for (const BuildOptions& options : AllBuildOptions()) {
    // A tree is built in the same way whatever it will be searched with, except for its width.
    const bool is_repeated = options.isa != Isa::kScalar && options.width == 8 &&
                             options.accelerator == AcceleratorKind::kBvh;
    if (is_repeated) continue;
    auto input = InputOf(description, options);
    ASSERT_TRUE(input.ok());
    for (const bool from_then_on : {false, true}) {
      fails_from_then_on = from_then_on;
      const int64_t allocations = ExpectEachFailureIsTold(
          *input, [&](GroupInput copy) { return Group::Build(std::move(copy), options); });
      EXPECT_GT(allocations, 5) << ToString(options);
    }
  }
}

TEST(OutOfMemory, QueriesAllocateNothing) {
  const GroupDescription description = Everything();
  UniformNumbers random(2);
  const std::vector<Ray> rays = RandomRays(description, 100, &random);
  for (const BuildOptions& options : AllBuildOptions()) {
    const auto group = MustBuild(description, options);
    std::vector<HitRecord> hits(rays.size());
    std::vector<uint8_t> occluded(rays.size());
    until_failure = 1;
    for (size_t i = 0; i < rays.size(); ++i) group->Intersect(rays[i], &hits[i]);
    for (const RayOrder order : {RayOrder::kScattered, RayOrder::kCoherent}) {
      group->Intersect(order, rays, hits);
      group->Occluded(order, rays, occluded);
    }
    EXPECT_EQ(until_failure, 1) << ToString(options);
    until_failure = kNever;
  }
}

}  // namespace
}  // namespace candela::test
