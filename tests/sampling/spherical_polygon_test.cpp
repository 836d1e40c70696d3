// Triangles and rectangles sampled by the solid angle under which they are seen.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "math/elementary.h"
#include "sampling/spherical_rectangle.h"
#include "sampling/spherical_triangle.h"
#include "tests/sampling/chi_square.h"

namespace candela {
namespace {

using test::ChiSquareDeviate;
using test::kLargestDeviate;
using test::UniformNumbers;

constexpr int kSamples = 1000000;
constexpr size_t kSide = 12;

struct Corners {
  const char* name;
  Vec3d a, b, c;
};

// Near and far, seen from the middle and from the side, nearly edge-on.
const Corners kTriangles[] = {
    {"octant", {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
    {"near", {-1, -1, 0.1}, {2, -1, 0.1}, {0, 2, 0.1}},
    {"far", {100, 0, 0}, {100, 1, 0}, {100, 0, 1}},
    {"edge-on", {-1, 0.05, 1}, {1, 0.05, 1}, {0, 0.06, 3}},
    {"sliver", {-1, 0, 1}, {1, 0, 1}, {1, 0.01, 1}},
};

TEST(SphericalTriangle, OfAnOctantHasAnEighthOfTheSphere) {
  EXPECT_NEAR(SphericalTriangle({2, 0, 0}, {0, 3, 0}, {0, 0, 4}).SolidAngle(), kPi / 2, 1e-6);
}

// P3: the pairs that samples are made of come back, and with them the same direction: with pairs
// evenly spread, each cell of them has its part of the solid angle only if the map preserves area,
// which the next test looks at.
TEST(SphericalTriangle, SamplesLieInsideAndInvert) {
  UniformNumbers numbers(1);
  for (const Corners& t : kTriangles) {
    const SphericalTriangle triangle(t.a, t.b, t.c);
    for (int i = 0; i < 20000; ++i) {
      const Vec2 u = numbers.NextPair();
      const Vec3d w = triangle.Sample(u);
      ASSERT_NEAR(Length(w), 1, 1e-12) << t.name;
      const double volume = Dot(t.a, Cross(t.b, t.c));
      for (const double part :
           {Dot(w, Cross(t.b, t.c)), Dot(w, Cross(t.c, t.a)), Dot(w, Cross(t.a, t.b))}) {
        ASSERT_GE(part / volume, -1e-9) << t.name;
      }
      const Vec2 back = triangle.Invert(w);
      ASSERT_NEAR(back.x, u.x, 1e-5f) << t.name << " " << u.x << " " << u.y;
      ASSERT_NEAR(back.y, u.y, 1e-5f) << t.name << " " << u.x << " " << u.y;
    }
  }
}

/// The share of the solid angle of each cell of a grid on a flat triangle or rectangle, by
/// midpoints of a finer grid: the integral of cosine over squared distance.
std::vector<double> SharesOfCells(Vec3d corner, Vec3d x, Vec3d y, bool is_triangle) {
  constexpr size_t kFine = 120;  // In each cell, each way.
  std::vector<double> shares(kSide * kSide);
  double sum = 0;
  const Vec3d n = Cross(x, y);
  for (size_t j = 0; j < kSide * kFine; ++j) {
    for (size_t i = 0; i < kSide * kFine; ++i) {
      const double u = (static_cast<double>(i) + 0.5) / (kSide * kFine);
      const double v = (static_cast<double>(j) + 0.5) / (kSide * kFine);
      if (is_triangle && i + j + 1 > kSide * kFine) continue;
      // On the long side half of the square belongs to the triangle.
      const double part = is_triangle && i + j + 1 == kSide * kFine ? 0.5 : 1;
      const Vec3d p = corner + x * u + y * v;
      const double density = part * std::abs(Dot(n, p)) / std::pow(LengthSquared(p), 1.5);
      shares[j / kFine * kSide + i / kFine] += density;
      sum += density;
    }
  }
  for (double& share : shares) share /= sum;
  return shares;
}

// P1
TEST(SphericalTriangle, FollowsItsDensity) {
  for (const Corners& t : kTriangles) {
    const SphericalTriangle triangle(t.a, t.b, t.c);
    UniformNumbers numbers(2);
    std::vector<uint64_t> counts(kSide * kSide);
    const Vec3d x = t.b - t.a, y = t.c - t.a, n = Cross(x, y);
    for (int i = 0; i < kSamples / 4; ++i) {
      const Vec3d w = triangle.Sample(numbers.NextPair());
      // Where the direction meets the triangle, in barycentric weights.
      const Vec3d p = w * (Dot(n, t.a) / Dot(n, w)) - t.a;
      const double u = Dot(Cross(p, y), n) / Dot(n, n), v = Dot(Cross(x, p), n) / Dot(n, n);
      auto column = std::min(static_cast<size_t>(std::max(u, 0.0) * kSide), kSide - 1);
      const auto row = std::min(static_cast<size_t>(std::max(v, 0.0) * kSide), kSide - 1);
      if (column + row >= kSide) column = kSide - 1 - row;  // Rounded across the long side.
      ++counts[row * kSide + column];
    }
    EXPECT_LT(ChiSquareDeviate(counts, SharesOfCells(t.a, x, y, true)), kLargestDeviate) << t.name;
  }
}

TEST(SphericalTriangle, OfTinySizeIsStillRight) {
  // Seen small, the solid angle is area times cosine over squared distance.
  const SphericalTriangle triangle({1000, 0, 0}, {1000, 1, 0}, {1000, 0, 1});
  EXPECT_NEAR(triangle.SolidAngle(), 0.5e-6, 1e-12);
  UniformNumbers numbers(3);
  for (int i = 0; i < 1000; ++i) {
    const Vec2 u = numbers.NextPair();
    const Vec2 back = triangle.Invert(triangle.Sample(u));
    ASSERT_NEAR(back.x, u.x, 1e-3f);
    ASSERT_NEAR(back.y, u.y, 1e-3f);
  }
}

struct Sides {
  const char* name;
  Vec3d corner, x, y;
};

const Sides kRectangles[] = {
    {"cube face", {-1, -1, -1}, {2, 0, 0}, {0, 2, 0}},
    {"near", {-1, -2, 0.05}, {3, 0, 0}, {0, 4, 0}},
    {"turned", {1, 2, 2}, {0.6, 0.8, 0}, {-1.6, 1.2, 0}},
    {"beside", {5, 3, 0.2}, {1, 0, 0}, {0, 2, 0}},
    {"far", {-0.5, 30, 100}, {1, 0, 0}, {0, 1, 0}},
    {"below the axis", {-3, -4, 1}, {2, 0, 0}, {0, 1, 0}},
};

TEST(SphericalRectangle, OfAFaceOfACubeHasASixthOfTheSphere) {
  EXPECT_NEAR(SeenRectangle({-1, -1, -1}, {2, 0, 0}, {0, 2, 0}).From({}).SolidAngle(), 4 * kPi / 6,
              1e-12);
}

// Scenes may have any unit of length that floats have room for.
TEST(SphericalRectangle, LooksTheSameAtEveryScale) {
  const Sides& r = kRectangles[1];
  const SphericalRectangle usual = SeenRectangle(r.corner, r.x, r.y).From({});
  for (const double scale : {1e-36, 1e36}) {
    const SphericalRectangle scaled =
        SeenRectangle(r.corner * scale, r.x * scale, r.y * scale).From({});
    EXPECT_NEAR(scaled.SolidAngle(), usual.SolidAngle(), 1e-12);
    UniformNumbers numbers(6);
    for (int i = 0; i < 100; ++i) {
      const Vec2 u = numbers.NextPair(), place = scaled.Sample(u), expected = usual.Sample(u);
      ASSERT_NEAR(place.x, expected.x, 1e-6f);
      ASSERT_NEAR(place.y, expected.y, 1e-6f);
    }
  }
}

TEST(SphericalRectangle, IsNotSeenFromNowhere) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(SphericalRectangle({nan, 0, 1}, 1, 1).SolidAngle(), 0);
  EXPECT_EQ(SphericalRectangle({0, 0, nan}, 1, 1).SolidAngle(), 0);
  EXPECT_EQ(SphericalRectangle({0, 0, 0}, 1, 1).SolidAngle(), 0);  // From one of its corners.
}

TEST(SphericalRectangle, TellsRectanglesFromParallelograms) {
  EXPECT_TRUE(SeenRectangle({}, {3, 4, 0}, {-4e6, 3e6, 0}).IsRightAngled());
  EXPECT_FALSE(SeenRectangle({}, {3, 4, 0}, {-4, 3.1, 0}).IsRightAngled());
}

// P3
TEST(SphericalRectangle, Inverts) {
  UniformNumbers numbers(4);
  for (const Sides& r : kRectangles) {
    const SphericalRectangle rectangle = SeenRectangle(r.corner, r.x, r.y).From({});
    for (int i = 0; i < 20000; ++i) {
      const Vec2 u = numbers.NextPair();
      const Vec2 place = rectangle.Sample(u);
      ASSERT_TRUE(place.x >= 0 && place.x <= 1 && place.y >= 0 && place.y <= 1);
      const Vec2 back = rectangle.Invert(place);
      ASSERT_NEAR(back.x, u.x, 1e-5f) << r.name << " " << u.x << " " << u.y;
      ASSERT_NEAR(back.y, u.y, 1e-5f) << r.name << " " << u.x << " " << u.y;
    }
  }
}

// P1
TEST(SphericalRectangle, FollowsItsDensity) {
  for (const Sides& r : kRectangles) {
    const SphericalRectangle rectangle = SeenRectangle(r.corner, r.x, r.y).From({});
    UniformNumbers numbers(5);
    std::vector<uint64_t> counts(kSide * kSide);
    for (int i = 0; i < kSamples / 4; ++i) {
      const Vec2 place = rectangle.Sample(numbers.NextPair());
      const auto column = std::min(static_cast<size_t>(place.x * kSide), kSide - 1);
      const auto row = std::min(static_cast<size_t>(place.y * kSide), kSide - 1);
      ++counts[row * kSide + column];
    }
    EXPECT_LT(ChiSquareDeviate(counts, SharesOfCells(r.corner, r.x, r.y, false)), kLargestDeviate)
        << r.name;
  }
}

}  // namespace
}  // namespace candela
