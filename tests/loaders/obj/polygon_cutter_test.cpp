#include "loaders/obj/polygon_cutter.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <utility>
#include <vector>

#include "base/clock.h"

namespace candela {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using Polygon = std::vector<Vec3>;
using Triangle = PolygonCutter::Triangle;

std::vector<Triangle> Cut(const Polygon& polygon) {
  PolygonCutter cutter;
  const auto triangles = cutter.Cut(polygon);
  return {triangles.begin(), triangles.end()};
}

Vec3d AreaVector(const Polygon& polygon, const Triangle& triangle) {
  const Vec3d a = ToDouble(polygon[triangle[0]]);
  return Cross(ToDouble(polygon[triangle[1]]) - a, ToDouble(polygon[triangle[2]]) - a);
}

/// The proof that triangles are the polygon: all turn the same way as it does, and of their edges
/// those of the polygon are left when opposite ones cancel. Then the triangles cover a point as
/// often as the outline winds around it, which is once inside and never outside.
void ExpectExactCut(const Polygon& polygon, Vec3d normal) {
  const std::vector<Triangle> triangles = Cut(polygon);
  EXPECT_EQ(triangles.size(), polygon.size() - 2);
  std::map<std::pair<uint32_t, uint32_t>, int> edges;
  const auto add = [&](uint32_t a, uint32_t b, int count) {
    edges[{std::min(a, b), std::max(a, b)}] += a < b ? count : -count;
  };
  for (const Triangle& triangle : triangles) {
    EXPECT_GT(Dot(AreaVector(polygon, triangle), normal), 0);
    for (int i = 0; i < 3; ++i) add(triangle[i], triangle[(i + 1) % 3], 1);
  }
  const auto count = static_cast<uint32_t>(polygon.size());
  for (uint32_t i = 0; i < count; ++i) add(i, (i + 1) % count, -1);
  for (const auto& [edge, left] : edges) EXPECT_EQ(left, 0) << edge.first << " " << edge.second;
}

/// The same in eight positions in space, turned both ways and from each first corner.
void ExpectExactCuts(const Polygon& flat) {
  for (size_t first = 0; first < flat.size(); ++first) {
    Polygon polygon = flat;
    std::rotate(polygon.begin(), polygon.begin() + static_cast<std::ptrdiff_t>(first),
                polygon.end());
    for (int way = 0; way < 8; ++way) {
      Polygon turned;
      for (const Vec3 p : polygon) {
        switch (way % 4) {
          case 0:
            turned.push_back({p.x, p.y, 3});
            break;
          case 1:
            turned.push_back({3, p.x, p.y});
            break;
          case 2:
            turned.push_back({p.y, 3, p.x});
            break;
          default:
            turned.push_back({p.x + p.y, p.y - 2 * p.x, p.x});
        }
      }
      Vec3d normal = way % 4 == 0   ? Vec3d{0, 0, 1}
                     : way % 4 == 1 ? Vec3d{1, 0, 0}
                     : way % 4 == 2 ? Vec3d{0, 1, 0}
                                    : Cross(Vec3d{1, -2, 1}, Vec3d{1, 1, 0});
      if (way >= 4) {
        std::reverse(turned.begin(), turned.end());
        normal = -normal;
      }
      ExpectExactCut(turned, normal);
    }
  }
}

/// A spiral corridor of `turns` half turns, one unit wide, in whole numbers: 2 * turns + 2 corners.
Polygon Spiral(int turns) {
  Polygon outer, inner;
  Vec3 p{0, 0, 0}, q{0, 1, 0};
  const Vec3 directions[] = {{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}};
  outer.push_back(p);
  inner.push_back(q);
  for (int i = 0; i < turns; ++i) {
    const Vec3 along = directions[i % 4], left = directions[(i + 1) % 4];
    const int rounds_left = (turns - i) / 2;
    const auto length = static_cast<float>(4 * (rounds_left + 2));
    p += along * length;
    // The inner side turns one unit earlier and to the left.
    q = p - along + left;
    outer.push_back(p);
    inner.push_back(q);
  }
  outer.insert(outer.end(), inner.rbegin(), inner.rend());
  return outer;
}

/// Around the origin with random radii: simple, with many hollow corners.
Polygon RandomStar(int corners, uint32_t* state) {
  const auto random = [&] { return (*state = *state * 1664525u + 1013904223u) >> 8; };
  Polygon polygon;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * 3.14159265358979 * i / corners;
    const double radius = 1 + random() % 1000;
    polygon.push_back({static_cast<float>(radius * std::cos(angle)),
                       static_cast<float>(radius * std::sin(angle)), 0});
  }
  return polygon;
}

/// A random walk of whole steps to the right and one back below it: many collinear corners.
Polygon RandomSkyline(int steps, uint32_t* state) {
  const auto random = [&] { return (*state = *state * 1664525u + 1013904223u) >> 28; };
  Polygon polygon;
  for (int x = 0; x <= steps; ++x) {
    polygon.push_back({static_cast<float>(x), -static_cast<float>(random() % 4), 0});
  }
  for (int x = steps; x >= 0; --x) {
    polygon.push_back({static_cast<float>(x), 1.0f + static_cast<float>(random() % 4), 0});
  }
  return polygon;
}

TEST(PolygonCutter, TooFewCornersAreNothing) {
  EXPECT_THAT(Cut({}), IsEmpty());
  EXPECT_THAT(Cut({{0, 0, 0}, {1, 0, 0}}), IsEmpty());
}

TEST(PolygonCutter, ConvexPolygonsAreFansFromTheFirstCorner) {
  EXPECT_THAT(Cut({{0, 0, 0}, {2, 0, 0}, {3, 1, 0}, {2, 2, 0}, {0, 2, 0}}),
              ElementsAre(Triangle{0, 1, 2}, Triangle{0, 2, 3}, Triangle{0, 3, 4}));
  // The third and fourth corner lie on an edge.
  EXPECT_THAT(Cut({{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {2, 2, 0}, {0, 2, 0}}),
              ElementsAre(Triangle{0, 1, 2}, Triangle{0, 2, 3}, Triangle{0, 3, 4}));
}

TEST(PolygonCutter, ArrowIsCutAlongItsOnlyDiagonal) {
  EXPECT_THAT(Cut({{0, 0, 0}, {2, -2, 0}, {1, 0, 0}, {2, 2, 0}}),
              testing::UnorderedElementsAre(Triangle{0, 1, 2}, Triangle{2, 3, 0}));
}

TEST(PolygonCutter, ConcavePolygonsAreCoveredExactly) {
  ExpectExactCuts({{0, 0, 0}, {2, -2, 0}, {1, 0, 0}, {2, 2, 0}});
  ExpectExactCuts({{0, 0, 0}, {4, 0, 0}, {4, 1, 0}, {1, 1, 0}, {1, 3, 0}, {0, 3, 0}});  // an L
  ExpectExactCuts({{0, 0, 0},
                   {5, 0, 0},
                   {5, 5, 0},
                   {4, 5, 0},
                   {4, 1, 0},
                   {3, 1, 0},
                   {3, 4, 0},
                   {2, 4, 0},
                   {2, 1, 0},
                   {1, 1, 0},
                   {1, 5, 0},
                   {0, 5, 0}});  // a comb
  ExpectExactCuts({{0, 8, 0},
                   {-2, 2, 0},
                   {-8, 2, 0},
                   {-3, -1, 0},
                   {-5, -7, 0},
                   {0, -3, 0},
                   {5, -7, 0},
                   {3, -1, 0},
                   {8, 2, 0},
                   {2, 2, 0}});  // a star, by its outline
}

TEST(PolygonCutter, SpiralIsCoveredExactly) {
  ExpectExactCuts(Spiral(9));
}

TEST(PolygonCutter, CollinearCornersAreKept) {
  ExpectExactCuts({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 2, 0}, {1, 1, 0}, {0, 2, 0}, {0, 1, 0}});
  ExpectExactCuts({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {0, 3, 0}, {0, 1, 0}});  // convex
}

TEST(PolygonCutter, RandomPolygonsAreCoveredExactly) {
  uint32_t state = 7;
  for (int corners = 4; corners < 60; ++corners) {
    SCOPED_TRACE(corners);
    for (int repeat = 0; repeat < 10; ++repeat) {
      ExpectExactCut(RandomStar(corners, &state), {0, 0, 1});
    }
  }
  for (int steps = 2; steps < 60; ++steps) {
    SCOPED_TRACE(steps);
    for (int repeat = 0; repeat < 10; ++repeat) {
      ExpectExactCut(RandomSkyline(steps, &state), {0, 0, 1});
    }
  }
}

double SignedArea(const Polygon& polygon) {
  double area = 0;
  for (const Triangle& triangle : Cut(polygon)) {
    const double twice = AreaVector(polygon, triangle).z;
    EXPECT_GE(twice, 0);
    area += twice / 2;
  }
  return area;
}

// A corner given twice, a hole joined to the outline by a bridge that is walked both ways, a spike:
// the edges touch themselves, and the area is still right without any triangle turned over.
TEST(PolygonCutter, PolygonsThatTouchThemselvesKeepTheirArea) {
  EXPECT_EQ(
      SignedArea({{0, 0, 0}, {2, 0, 0}, {2, 0, 0}, {1, 1, 0}, {2, 2, 0}, {0, 2, 0}, {0, 0, 0}}), 3);
  EXPECT_EQ(SignedArea({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {6, 4, 0}, {4, 4, 0}, {0, 4, 0}}), 16);
  EXPECT_EQ(SignedArea({{0, 0, 0},
                        {6, 0, 0},
                        {6, 6, 0},
                        {0, 6, 0},
                        {0, 0, 0},
                        {2, 2, 0},
                        {2, 4, 0},
                        {4, 4, 0},
                        {4, 2, 0},
                        {2, 2, 0}}),
            32);
}

TEST(PolygonCutter, BowTieWithoutNetAreaIsAFan) {
  EXPECT_THAT(Cut({{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}}),
              ElementsAre(Triangle{0, 1, 2}, Triangle{0, 2, 3}));
}

TEST(PolygonCutter, LargeFacesTakeLittleTime) {
  uint32_t state = 1;
  Polygon crossing, comb, repeated;
  for (int i = 0; i < 100'000; ++i) {
    state = state * 1664525u + 1013904223u;
    const auto x = static_cast<float>(state >> 20);
    state = state * 1664525u + 1013904223u;
    crossing.push_back({x, static_cast<float>(state >> 20), 0});
    comb.push_back({static_cast<float>(i), i % 2 == 0 ? 0.0f : 1000.0f, 0});
    const Vec3 arrow[] = {{0, 0, 0}, {2, -2, 0}, {1, 0, 0}, {2, 2, 0}};
    repeated.push_back(arrow[i % 4]);
  }
  comb.push_back({50'000, -1, 0});
  for (const Polygon& polygon : {Spiral(2000), RandomStar(100'000, &state),
                                 RandomSkyline(50'000, &state), crossing, comb, repeated}) {
    const Stopwatch watch;
    Cut(polygon);
    EXPECT_LT(watch.Seconds(), 10) << polygon.size();
  }
}

}  // namespace
}  // namespace candela
