// After a refit a group answers for the new positions.
#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "tests/kernel/full_search.h"
#include "tests/kernel/random_group.h"
#include "tests/kernel/sphere_set.h"
#include "tests/kernel/trace_lists.h"

namespace candela::test {
namespace {

/// Meshes at rest and moving, spheres, and instances of one group: each time elsewhere, with the
/// same structure.
class Arrangement {
 public:
  const GroupDescription& Next() {
    group_ = {};
    group_.Add(Moved(BumpyGlobe(12, 16, 0.3f, &random_), 0.5f, RandomPoint(&random_)));
    const TestMesh grid = Moved(CurvedGrid(8, random_.Next()), 0.7f, RandomPoint(&random_));
    group_.Add(InMotion(grid, 3, 0.3f, &random_));
    group_.Add(Soup(100, 0.1f, 0.5f, &random_));
    std::vector<SphereSet::Sphere> spheres;
    for (int i = 0; i < 30; ++i) {
      spheres.push_back({{RandomPoint(&random_)}, 0.01f + 0.1f * random_.Next()});
    }
    spheres_->Replace(std::move(spheres));
    group_.items.push_back({spheres_, kAnyRay, nullptr});
    for (int i = 0; i < 5; ++i) {
      std::vector<Mat4> matrices = {RandomMove()};
      if (i % 2 == 1) matrices.push_back(RandomMove());
      group_.items.push_back({GroupDescription::Instance{inner_, matrices}, kAnyRay, nullptr});
    }
    return group_;
  }

 private:
  Mat4 RandomMove() { return Mat4::Translate(ToDouble(RandomPoint(&random_))); }

  UniformNumbers random_{1};
  std::shared_ptr<SphereSet> spheres_ =
      std::make_shared<SphereSet>(std::vector<SphereSet::Sphere>());
  std::shared_ptr<const GroupDescription> inner_ =
      std::make_shared<GroupDescription>(OfMesh(Moved(Star(6, 9, 3), 0.3f, {})));
  GroupDescription group_;
};

int CountWrong(const Group& group, const GroupDescription& description,
               const std::vector<Ray>& rays, const std::string& where) {
  const FullSearch search(description);
  int wrong = 0;
  for (const Entry entry : kEntries) {
    const auto hits = IntersectList(group, entry, rays);
    for (size_t i = 0; i < rays.size(); ++i) {
      HitRecord right;
      right.t = rays[i].t_max;
      search.Intersect(rays[i], &right);
      if (IsSame(hits[i], right) || ++wrong > 1) continue;
      ADD_FAILURE() << where << ", " << ToString(entry) << ": " << ToString(rays[i]) << "\n  found "
                    << ToString(hits[i]) << "\n  right " << ToString(right);
    }
  }
  return wrong;
}

TEST(Refit, AnswersForTheNewPlaces) {
  for (const BuildOptions& options : TreeBuildOptions()) {
    Arrangement arrangement;
    BuiltGroups built;
    auto first = InputOf(arrangement.Next(), options, &built);
    ASSERT_TRUE(first.ok());
    const auto group = Group::Build(*std::move(first), options);
    ASSERT_TRUE(group.ok());
    UniformNumbers random(2);
    for (int i = 0; i < 5; ++i) {
      const GroupDescription& moved = arrangement.Next();
      const auto input = InputOf(moved, options, &built);
      ASSERT_TRUE(input.ok());
      const auto done = (*group)->Refit(*input);
      ASSERT_TRUE(done.ok()) << done.error().message;
      const std::vector<Ray> rays = RandomRays(moved, 500, &random);
      EXPECT_EQ(CountWrong(**group, moved, rays, ToString(options)), 0);
    }
  }
}

// The triangles of one leaf are moved apart, and those that were split are elsewhere.
TEST(Refit, OfATreeThatFitsNoMoreIsSlowButRight) {
  UniformNumbers random(3);
  const TestMesh before = Join({Soup(300, 1e-3f, 2, &random), Slivers(100, 1e-3f, &random)});
  TestMesh after = before;
  for (Vec3& p : after.positions) p = RandomPoint(&random);
  const GroupDescription moved = OfMesh(after);
  const std::vector<Ray> rays = RandomRays(moved, 500, &random);
  for (const BuildOptions& options : TreeBuildOptions()) {
    const auto group = MustBuild(OfMesh(before), options);
    const auto input = InputOf(moved, options);
    ASSERT_TRUE(input.ok() && group->Refit(*input).ok());
    EXPECT_EQ(CountWrong(*group, moved, rays, ToString(options)), 0);
  }
}

TEST(Refit, ToAnotherNumberOfTrianglesFailsAndChangesNothing) {
  const GroupDescription globe = OfMesh(Globe(10, 10));
  UniformNumbers random(4);
  const std::vector<Ray> rays = RandomRays(globe, 200, &random);
  for (const BuildOptions& options : TreeBuildOptions()) {
    const auto group = MustBuild(globe, options);
    for (const int rows : {5, 20}) {
      const auto other = OfMesh(Globe(rows, rows));
      const auto input = InputOf(other, options);
      ASSERT_TRUE(input.ok());
      const auto done = group->Refit(*input);
      ASSERT_FALSE(done.ok()) << rows;
      EXPECT_EQ(done.error().code, ErrorCode::kUsage);
    }
    EXPECT_EQ(CountWrong(*group, globe, rays, ToString(options)), 0);
  }
}

TEST(Refit, IsForTreesAlone) {
  const GroupDescription globe = OfMesh(Globe(10, 10));
  for (const AcceleratorEntry& entry : Accelerators()) {
    BuildOptions options;
    options.accelerator = entry.kind;
    const auto group = MustBuild(globe, options);
    const auto input = InputOf(globe, options);
    ASSERT_TRUE(input.ok());
    const auto done = group->Refit(*input);
    EXPECT_EQ(done.ok(), entry.kind == AcceleratorKind::kBvh) << entry.name;
    if (!done) {
      EXPECT_EQ(done.error().code, ErrorCode::kUsage);
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
