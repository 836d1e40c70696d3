// A line through a closed shape goes in, out, in, out: what a medium inside depends on.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>
#include <string_view>
#include <vector>

#include "tests/contract/rows.h"
#include "tests/sampling/chi_square.h"
#include "tests/support/lines.h"

namespace candela {
namespace {

using contract::SceneOfShape;
using testing_support::Crossings;
using testing_support::FollowLine;
using testing_support::LineThroughBall;

/// Calls `check` with what so many lines through a scene meet.
template <class Check>
void ForLines(const Scene& scene, int count, const Check& check) {
  Bounds3 box = scene.Bounds();
  if (box.IsEmpty()) box = {{-1, -1, -1}, {1, 1, 1}};
  const float radius = Length(box.Extent()) / 2;
  test::UniformNumbers random(13);
  for (int i = 0; i < count; ++i) {
    const Vec2 u_direction = random.NextPair();
    const Ray line = LineThroughBall(box.Center(), radius, u_direction, random.NextPair());
    check(FollowLine(scene, line.origin, line.direction));
  }
}

/// No line ends inside of a closed shape; half of those that meet an open one do.
std::vector<ShapeEntry> Rows(bool are_closed) {
  std::vector<ShapeEntry> rows;
  for (const ShapeEntry& entry : ShapeEntries()) {
    int odd = 0;
    ForLines(*SceneOfShape(entry.example), 1000,
             [&](const Crossings& line) { odd += line.count % 2; });
    if ((odd < 10) == are_closed) rows.push_back(entry);
  }
  return rows;
}

TEST(CrossingsContract, TheseShapesAreOpen) {
  std::vector<std::string_view> names;
  for (const ShapeEntry& entry : Rows(false)) names.push_back(entry.name);
  EXPECT_THAT(names, testing::ElementsAre("plane", "triangle", "rectangle", "disk"));
}

class EveryClosedShape : public testing::TestWithParam<ShapeEntry> {};

INSTANTIATE_TEST_SUITE_P(Registry, EveryClosedShape, testing::ValuesIn(Rows(true)),
                         contract::RowName<ShapeEntry>);

TEST_P(EveryClosedShape, IsEnteredAndLeftInTurns) {
  for (const auto& [outer, inner] :
       {std::pair{"", ""}, std::pair{"translate 100 -30 7 x_rotate 30", "scale 1 3 0.5"},
        std::pair{"scale -1 1 1", "y_rotate 20"}}) {
    int met = 0, wrong = 0;
    ForLines(*SceneOfShape(GetParam().example, outer, inner), 100000, [&](const Crossings& line) {
      met += line.count > 0;
      wrong += !line.alternates;
    });
    EXPECT_GT(met, 5000);
    // A line may graze an edge, where in and out fall together.
    EXPECT_LE(wrong, 2);
  }
}

}  // namespace
}  // namespace candela
