// After a refit a group answers for the new positions.
#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "tests/kernel/random_group.h"
#include "tests/kernel/sphere_set.h"
#include "tests/kernel/trace_lists.h"

namespace candela::test {
namespace {

/// Meshes at rest and moving, spheres, and instances of one group; other places for other seeds,
/// the same structure always.
GroupDescription Arrangement(const std::shared_ptr<const GroupDescription>& inner, uint32_t seed) {
  UniformNumbers random(seed);
  const auto moved = [&] { return Mat4::Translate(ToDouble(RandomPoint(&random))); };
  GroupDescription group;
  group.Add(Moved(BumpyGlobe(12, 16, 0.3f, &random), 0.5f, RandomPoint(&random)));
  group.Add(
      InMotion(Moved(CurvedGrid(8, random.Next()), 0.7f, RandomPoint(&random)), 3, 0.3f, &random));
  group.Add(Soup(100, 0.1f, 0.5f, &random));
  std::vector<SphereSet::Sphere> spheres;
  for (int i = 0; i < 30; ++i) {
    spheres.push_back({{RandomPoint(&random)}, 0.01f + 0.1f * random.Next()});
  }
  group.items.push_back({std::make_shared<SphereSet>(spheres), kAnyRay, nullptr});
  for (int i = 0; i < 5; ++i) {
    std::vector<Mat4> matrices = {moved()};
    if (i % 2 == 1) matrices.push_back(moved());
    group.items.push_back({GroupDescription::Instance{inner, matrices}, kAnyRay, nullptr});
  }
  return group;
}

TEST(Refit, AnswersForTheNewPlaces) {
  const auto inner = std::make_shared<GroupDescription>(OfMesh(Moved(Star(6, 9, 3), 0.3f, {})));
  for (const BuildOptions& options : AllBuildOptions()) {
    const auto group = MustBuild(Arrangement(inner, 0), options);
    for (uint32_t seed = 1; seed < 5; ++seed) {
      const GroupDescription arrangement = Arrangement(inner, seed);
      auto input = InputOf(arrangement, options);
      ASSERT_TRUE(input.ok());
      const auto done = group->Refit(*input);
      ASSERT_TRUE(done.ok()) << done.error().message;

      UniformNumbers random(seed);
      const std::vector<Ray> rays = RandomRays(arrangement, 500, &random);
      int wrong = 0;
      for (const Entry entry : kEntries) {
        const auto hits = IntersectList(*group, entry, rays);
        for (size_t i = 0; i < rays.size(); ++i) {
          HitRecord right;
          right.t = rays[i].t_max;
          IntersectAll(arrangement, rays[i], &right);
          if (IsSame(hits[i], right) || ++wrong > 1) continue;
          ADD_FAILURE() << ToString(options) << ", " << ToString(entry) << ": " << ToString(rays[i])
                        << "\n  found " << ToString(hits[i]) << "\n  right " << ToString(right);
        }
      }
      EXPECT_EQ(wrong, 0);
    }
  }
}

TEST(Refit, BoundsFollow) {
  const auto group = MustBuild(OfMesh(Globe(10, 10)), {});
  const GroupDescription far = OfMesh(Moved(Globe(10, 10), 2, {10, 20, 30}));
  auto input = InputOf(far, {});
  ASSERT_TRUE(input.ok());
  ASSERT_TRUE(group->Refit(*input).ok());
  EXPECT_NEAR(group->Bounds().min.x, 8, 0.2);
  EXPECT_NEAR(group->Bounds().max.z, 32, 0.2);
}

}  // namespace
}  // namespace candela::test
