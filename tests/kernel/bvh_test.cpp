#include "kernel/bvh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "tests/sampling/chi_square.h"

namespace candela {
namespace {

using test::UniformNumbers;

constexpr float kLargest = std::numeric_limits<float>::max();

Vec3 RandomPoint(UniformNumbers* random) {
  const Vec2 xy = random->NextPair();
  return {2 * xy.x - 1, 2 * xy.y - 1, 2 * random->Next() - 1};
}

Bounds3 BoxAround(Vec3 center, Vec3 half_size) {
  return {center - half_size, center + half_size};
}

std::vector<uint32_t> Visited(const Bvh& bvh, const Ray& ray, float t_limit = kLargest) {
  std::vector<uint32_t> items;
  bvh.Traverse(ray, &t_limit, [&](uint32_t item) {
    items.push_back(item);
    return false;
  });
  std::sort(items.begin(), items.end());
  return items;
}

/// The slab test in double, with the parallel case in words.
bool Meets(const Ray& ray, const Bounds3& box) {
  double entry = static_cast<double>(ray.t_min), exit = static_cast<double>(ray.t_max);
  for (int axis = 0; axis < 3; ++axis) {
    const Vec3d o = ToDouble(ray.origin), d = ToDouble(ray.direction);
    const Vec3d low = ToDouble(box.min), high = ToDouble(box.max);
    if (d[axis] == 0) {
      if (o[axis] < low[axis] || o[axis] > high[axis]) return false;
      continue;
    }
    const double t0 = (low[axis] - o[axis]) / d[axis], t1 = (high[axis] - o[axis]) / d[axis];
    entry = std::max(entry, std::min(t0, t1));
    exit = std::min(exit, std::max(t0, t1));
  }
  return entry <= exit;
}

/// Each box that a ray meets is visited, once. Returns how many boxes were visited.
size_t ExpectFindsAll(const std::vector<Bounds3>& boxes, const Bvh& bvh, const Ray& ray) {
  const std::vector<uint32_t> items = Visited(bvh, ray);
  EXPECT_EQ(std::adjacent_find(items.begin(), items.end()), items.end());
  for (uint32_t i = 0; i < boxes.size(); ++i) {
    if (boxes[i].IsEmpty() || !Meets(ray, boxes[i])) continue;
    EXPECT_TRUE(std::binary_search(items.begin(), items.end(), i)) << "box " << i;
  }
  return items.size();
}

TEST(Bvh, OfNothingVisitsNothing) {
  EXPECT_TRUE(Visited(Bvh(), Ray({0, 0, 0}, {0, 0, 1})).empty());
  const Bvh bvh(std::vector<Bounds3>{});
  EXPECT_TRUE(Visited(bvh, Ray({0, 0, 0}, {0, 0, 1})).empty());
  EXPECT_TRUE(bvh.Bounds().IsEmpty());
  EXPECT_EQ(bvh.Depth(), 0);
}

TEST(Bvh, OfOneBoxVisitsItWhenHit) {
  const Bvh bvh(std::vector<Bounds3>{{{-1, -1, 4}, {1, 1, 5}}});
  EXPECT_EQ(Visited(bvh, Ray({0, 0, 0}, {0, 0, 1})), (std::vector<uint32_t>{0}));
  EXPECT_TRUE(Visited(bvh, Ray({0, 0, 0}, {0, 0, -1})).empty());
  EXPECT_TRUE(Visited(bvh, Ray({2, 0, 0}, {0, 0, 1})).empty());
}

TEST(Bvh, EmptyBoxesAreNeverVisited) {
  const std::vector<Bounds3> boxes = {{}, {{-1, -1, 4}, {1, 1, 5}}, {}};
  EXPECT_EQ(Visited(Bvh(boxes), Ray({0, 0, 0}, {0, 0, 1})), (std::vector<uint32_t>{1}));
}

TEST(Bvh, ABoxEnteredAtTheLimitCountsAndOneBehindItDoesNot) {
  const Bvh bvh(std::vector<Bounds3>{{{-1, -1, 4}, {1, 1, 5}}});
  EXPECT_EQ(Visited(bvh, Ray({0, 0, 0}, {0, 0, 1}), 4.0f).size(), 1u);
  EXPECT_EQ(Visited(bvh, Ray({0, 0, 0}, {0, 0, 1}), 3.99f).size(), 0u);
}

TEST(Bvh, ABoxThatEndsBeforeTheLowerLimitIsNotVisited) {
  const Bvh bvh(std::vector<Bounds3>{{{-1, -1, 4}, {1, 1, 5}}});
  Ray ray({0, 0, 0}, {0, 0, 1});
  ray.t_min = 5;
  EXPECT_EQ(Visited(bvh, ray).size(), 1u);
  ray.t_min = 5.01f;
  EXPECT_EQ(Visited(bvh, ray).size(), 0u);
}

TEST(Bvh, StopsWhenTheVisitorSaysSo) {
  const std::vector<Bounds3> boxes(100, {{-1, -1, 4}, {1, 1, 5}});
  int visits = 0;
  const float limit = kLargest;
  Bvh(boxes).Traverse(Ray({0, 0, 0}, {0, 0, 1}), &limit, [&](uint32_t) { return ++visits == 3; });
  EXPECT_EQ(visits, 3);
}

TEST(Bvh, LoweringTheLimitCullsWhatIsBehind) {
  std::vector<Bounds3> boxes;
  for (int i = 0; i < 1000; ++i) {
    const auto z = static_cast<float>(i);
    boxes.push_back({{-1, -1, z}, {1, 1, z + 0.5f}});
  }
  int visits = 0;
  float limit = kLargest;
  Bvh(boxes).Traverse(Ray({0, 0, -1}, {0, 0, 1}), &limit, [&](uint32_t item) {
    limit = std::min(limit, 1 + static_cast<float>(item));
    ++visits;
    return false;
  });
  EXPECT_LE(visits, 8);  // Two leaves at most.
}

TEST(Bvh, FindsWhatBruteForceFindsInRandomBoxes) {
  UniformNumbers random(1);
  for (const size_t count : {2u, 3u, 5u, 17u, 300u}) {
    std::vector<Bounds3> boxes(count);
    for (Bounds3& box : boxes)
      box = BoxAround(RandomPoint(&random), Abs(RandomPoint(&random)) * 0.1f);
    const Bvh bvh(boxes);
    for (int i = 0; i < 2000; ++i) {
      const Vec3 origin = RandomPoint(&random) * 2;
      ExpectFindsAll(boxes, bvh, Ray(origin, RandomPoint(&random) - origin));
    }
  }
}

// The origin lies on the border of slabs that the ray is parallel to: 0 * infinity is not a number.
TEST(Bvh, RaysAlongTheFacesAndEdgesOfBoxesMeetThem) {
  std::vector<Bounds3> boxes;
  for (int i = 0; i < 64; ++i) {
    const Vec3 corner{static_cast<float>(i % 4), static_cast<float>(i / 4 % 4),
                      static_cast<float>(i / 16)};
    boxes.push_back({corner, corner + Vec3{1, 1, 1}});
  }
  const Bvh bvh(boxes);
  for (int axis = 0; axis < 3; ++axis) {
    for (const float sign : {-1.0f, 1.0f}) {
      for (const float zero : {0.0f, -0.0f}) {
        for (int i = 0; i < 81; ++i) {  // Corners, edges and the middle of faces.
          Vec3 origin, direction{zero, zero, zero};
          direction[axis] = sign;
          origin[axis] = sign > 0 ? -1.0f : 5.0f;
          origin[(axis + 1) % 3] = static_cast<float>(i % 9) / 2;
          origin[(axis + 2) % 3] = static_cast<float>(i / 9) / 2;
          EXPECT_GE(ExpectFindsAll(boxes, bvh, Ray(origin, direction)), 4u);
        }
      }
    }
  }
}

TEST(Bvh, BoxesWithoutVolumeAreMet) {
  std::vector<Bounds3> boxes;
  UniformNumbers random(2);
  for (int i = 0; i < 100; ++i) {
    Vec3 half = Abs(RandomPoint(&random)) * 0.2f;
    half[i % 3] = 0;                        // A rectangle,
    if (i % 2 == 0) half[(i + 1) % 3] = 0;  // a line,
    if (i % 4 == 0) half[(i + 2) % 3] = 0;  // a point.
    boxes.push_back(BoxAround(RandomPoint(&random), half));
  }
  const Bvh bvh(boxes);
  for (int i = 0; i < 10000; ++i) {
    const Bounds3& box = boxes[static_cast<size_t>(i) % boxes.size()];
    Vec3 direction;
    direction[i / 100 % 3] = i % 2 == 0 ? 1.0f : -1.0f;
    // The origin has two coordinates of the box, so the ray passes through it exactly.
    ExpectFindsAll(boxes, bvh, Ray(box.min - direction * 4, direction));
  }
}

// Squares and cubes of these leave the range of single precision.
TEST(Bvh, SizeDoesNotMatter) {
  UniformNumbers random(3);
  std::vector<Bounds3> unit(500);
  for (Bounds3& box : unit)
    box = BoxAround(RandomPoint(&random), Abs(RandomPoint(&random)) * 0.02f);
  for (const float scale : {0x1p-100f, 0x1p-66f, 0x1p66f, 0x1p100f, 0x1p126f}) {
    std::vector<Bounds3> boxes;
    for (const Bounds3& box : unit) boxes.push_back({box.min * scale, box.max * scale});
    const Bvh bvh(boxes);
    EXPECT_LE(bvh.Depth(), 20) << scale;
    size_t visited = 0;
    for (int i = 0; i < 500; ++i) {
      const Vec3 origin = RandomPoint(&random);
      const Vec3 direction = RandomPoint(&random) - origin;
      visited += ExpectFindsAll(boxes, bvh, Ray(origin * scale, direction));
    }
    EXPECT_LT(visited, 500u * 20) << scale;
  }
}

TEST(Bvh, AMillionCoincidentBoxesMakeABalancedTree) {
  const std::vector<Bounds3> boxes(1000000, {{-1, -1, 4}, {1, 1, 5}});
  const Bvh bvh(boxes);
  EXPECT_LE(bvh.Depth(), Bvh::kMostDepth);
  EXPECT_EQ(Visited(bvh, Ray({0, 0, 0}, {0, 0, 1})).size(), boxes.size());
}

// The surface area heuristic peels such boxes off one by one; halving ends that in time.
TEST(Bvh, ExponentiallySpacedBoxesDoNotMakeADeepTree) {
  std::vector<Bounds3> boxes;
  for (int repeat = 0; repeat < 20; ++repeat) {
    for (int exponent = -126; exponent < 127; ++exponent) {
      const float x = std::ldexp(1.0f, exponent);
      boxes.push_back({{x, 0, 0}, {x * 1.25f, 1, 1}});
      boxes.push_back({{-x * 1.25f, x, 0}, {-x, x * 1.25f, x}});
    }
  }
  const Bvh bvh(boxes);
  EXPECT_GT(bvh.Depth(), 20);
  EXPECT_LE(bvh.Depth(), Bvh::kMostDepth);
  EXPECT_EQ(ExpectFindsAll(boxes, bvh, Ray({0, 0.5f, 0.5f}, {1, 0, 0})), boxes.size() / 2);
}

TEST(Bvh, BoundsContainEverything) {
  const Bvh bvh(std::vector<Bounds3>{{{0, 0, 0}, {1, 1, 1}}, {}, {{-5, 2, 0}, {-4, 3, 9}}});
  EXPECT_EQ(bvh.Bounds(), (Bounds3{{-5, 0, 0}, {1, 3, 9}}));
}

}  // namespace
}  // namespace candela
