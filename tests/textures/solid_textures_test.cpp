// Textures that are computed from a place in space.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "math/elementary.h"
#include "math/mat4.h"
#include "math/transform.h"
#include "tests/textures/make_texture.h"
#include "textures/cell_noise.h"
#include "textures/fractal_noise.h"
#include "textures/gradient_noise.h"

namespace candela {
namespace {

using testing::IsEmpty;

std::shared_ptr<const Texture> Make(const std::string& type, const std::string& text) {
  Diagnostics diagnostics;
  auto texture = test::MakeTexture(type, text, ".", &diagnostics);
  EXPECT_THAT(diagnostics.Lines(), IsEmpty());
  return texture;
}

SurfacePoint Place(Vec3 p) {
  SurfacePoint point;
  point.p = p;
  point.n_geometric = point.n_shading = {0, 0, 1};
  return point;
}

/// Places that fill a cube of the given side evenly enough.
Vec3 Scattered(int i, float side) {
  const auto part = [i](double ratio) { return static_cast<float>(std::fmod(ratio * i, 1.0)); };
  return Vec3{part(0.8191725133961645), part(0.6710436067037893), part(0.5497004779019703)} * side;
}

TEST(GradientNoise, IsZeroAtWholePointsAndAroundZero) {
  EXPECT_EQ(GradientNoise({3, -7, 12}), 0);
  constexpr int kPlaces = 400000;
  double sum = 0, magnitude = 0;
  float most = 0;
  for (int i = 0; i < kPlaces; ++i) {
    const float value = GradientNoise(Scattered(i, 200));
    sum += static_cast<double>(value);
    magnitude += static_cast<double>(std::abs(value));
    most = std::max(most, std::abs(value));
  }
  EXPECT_NEAR(sum / kPlaces, 0, 2e-3);
  EXPECT_NEAR(magnitude / kPlaces, static_cast<double>(kMeanGradientNoise), 1e-3);
  EXPECT_GT(most, 0.8f);
  EXPECT_LE(most, 1);
}

// Its slope is at most that of the steepest gradient and of the blend.
TEST(GradientNoise, HasNoStepsBetweenCells) {
  constexpr float kStep = 0x1p-10f;
  for (int i = 0; i < 100000; ++i) {
    const Vec3 p = Scattered(i, 50);
    EXPECT_NEAR(GradientNoise(p), GradientNoise(p + Vec3{kStep, kStep, kStep}), 12 * kStep);
  }
}

TEST(GradientNoise, IsFiniteFarAway) {
  EXPECT_EQ(GradientNoise({3e38f, 0.5f, 0.5f}), 0);
  EXPECT_EQ(GradientNoise({std::numeric_limits<float>::quiet_NaN(), 0, 0}), 0);
}

TEST(FractalNoise, FadesToItsMeanOverAWidth) {
  const FractalNoise noise(4, 0.5f, 2);
  EXPECT_NE(noise.Motion({0.3f, 0.4f, 0.5f}, 0), 0);
  EXPECT_EQ(noise.Motion({0.3f, 0.4f, 0.5f}, 1), 0);
  EXPECT_FLOAT_EQ(noise.Turbulence({0.3f, 0.4f, 0.5f}, 1), kMeanGradientNoise);
  // A width of a quarter hides the third and the fourth copy, which have periods of 1/4 and 1/8.
  const FractalNoise coarse(2, 0.5f, 2);
  EXPECT_FLOAT_EQ(noise.Motion({0.3f, 0.4f, 0.5f}, 0.25f) * (1 + 0.5f + 0.25f + 0.125f),
                  coarse.Motion({0.3f, 0.4f, 0.5f}, 0.25f) * (1 + 0.5f));
}

TEST(NoiseTexture, LiesBetweenItsColours) {
  const auto texture = Make("noise", "low 1 0 0 high 0 0 2 octaves 3");
  float least = 1, most = 0;
  for (int i = 0; i < 10000; ++i) {
    const Rgb c = texture->Lookup(Place(Scattered(i, 30)));
    EXPECT_EQ(c.y, 0);
    EXPECT_NEAR(c.x + c.z / 2, 1, 1e-6f);
    least = std::min(least, c.x);
    most = std::max(most, c.x);
  }
  EXPECT_LT(least, 0.25f);
  EXPECT_GT(most, 0.75f);
}

TEST(NoiseTexture, IsScaledTurnedAndMoved) {
  const auto plain = Make("noise", "");
  const auto moved = Make("noise", "scale 2 4 1 rotation 0 0 90 offset 1 2 3");
  const Vec3 p{0.3f, 0.2f, 0.7f};
  EXPECT_NEAR(moved->Lookup(Place(p)).x,
              plain->Lookup(Place({1 - 4 * p.y, 2 + 2 * p.x, 3 + p.z})).x, 1e-6f);
}

// Of an object that is twice as large in the world, the width of a pixel is half as large.
TEST(NoiseTexture, StaysWithItsObject) {
  const auto texture = Make("noise", "octaves 1");
  const auto in_world = Make("noise", "octaves 1 space world");
  const MovingTransform space({Mat4::Translate({1, 2, 3}) * Mat4::Scale({2, 2, 2})});
  SurfacePoint point = Place({1.6f, 3.2f, 4.4f});
  const float there = texture->Lookup(Place({0.3f, 0.6f, 0.7f})).x;
  EXPECT_NE(texture->Lookup(point).x, there);
  EXPECT_EQ(texture->Lookup(point).x, in_world->Lookup(point).x);
  const float unmoved = in_world->Lookup(point).x;
  point.object_space = &space;
  EXPECT_NEAR(texture->Lookup(point).x, there, 1e-6f);
  EXPECT_EQ(in_world->Lookup(point).x, unmoved);
  point.footprint = 1.01f;
  EXPECT_EQ(in_world->Lookup(point).x, 0.5f);
  EXPECT_NE(texture->Lookup(point).x, 0.5f);
}

TEST(NoiseTexture, FollowsTextureCoordinates) {
  const auto texture = Make("noise", "space uv");
  SurfacePoint point = Place({5, 6, 7});
  point.uv = {0.3f, 0.6f};
  EXPECT_EQ(texture->Lookup(point), Make("noise", "")->Lookup(Place({0.3f, 0.6f, 0})));
}

TEST(MarbleTexture, WithoutStrengthIsMadeOfSheetsAUnitApart) {
  const auto texture = Make("marble", "strength 0");
  for (const float x : {0.0f, 3.0f, -2.0f}) {
    EXPECT_NEAR(texture->Lookup(Place({x, 0.4f, 9})).x, 0.5f, 1e-6f);
    EXPECT_NEAR(texture->Lookup(Place({x + 0.25f, 0.4f, 9})).x, 1, 1e-6f);
    EXPECT_NEAR(texture->Lookup(Place({x + 0.75f, 0.4f, 9})).x, 0, 1e-6f);
  }
  EXPECT_NE(Make("marble", "")->Lookup(Place({0.25f, 0.4f, 9})).x, 1);
}

TEST(WoodTexture, WithoutStrengthIsMadeOfRingsAroundY) {
  const auto texture = Make("wood", "strength 0");
  EXPECT_NEAR(texture->Lookup(Place({0.3f, 7, 0.4f})).x, 0.5f / 0.8f, 1e-6f);
  EXPECT_NEAR(texture->Lookup(Place({0.5f, 1, 0})).x, 0.5f / 0.8f, 1e-6f);
  EXPECT_NEAR(texture->Lookup(Place({0, 1, 2.9f})).x, 0.5f, 1e-5f);
}

/// By a look at all points around.
CellPoints BruteForce(Vec3 p, float jitter) {
  CellPoints found{1e9f, 1e9f, 0};
  for (int i = -4; i <= 4; ++i) {
    for (int j = -4; j <= 4; ++j) {
      for (int k = -4; k <= 4; ++k) {
        // A place in the middle of a cell without jitter has that cell's point at distance 0.
        const Vec3 cell{std::floor(p.x) + static_cast<float>(i),
                        std::floor(p.y) + static_cast<float>(j),
                        std::floor(p.z) + static_cast<float>(k)};
        const uint32_t hash = HashOfCell(static_cast<int>(cell.x), static_cast<int>(cell.y),
                                         static_cast<int>(cell.z));
        const auto offset = [&](int shift) {
          const auto part = static_cast<float>(hash >> shift & 0x3FFu) / 1023;
          return 0.5f + (part - 0.5f) * jitter;
        };
        const float distance = Length(cell + Vec3{offset(0), offset(10), offset(20)} - p);
        if (distance < found.nearest) {
          found.second = found.nearest;
          found.nearest = distance;
        } else {
          found.second = std::min(found.second, distance);
        }
      }
    }
  }
  return found;
}

TEST(CellNoise, FindsTheTwoNearestPoints) {
  for (const float jitter : {0.0f, 0.5f, 1.0f}) {
    for (int i = 0; i < 3000; ++i) {
      const Vec3 p = Scattered(i, 40) - Vec3{20, 20, 20};
      const CellPoints found = NearestCellPoints(p, jitter), all = BruteForce(p, jitter);
      ASSERT_NEAR(found.nearest, all.nearest, 1e-5f) << jitter;
      ASSERT_NEAR(found.second, all.second, 1e-5f) << jitter;
    }
  }
}

TEST(VoronoiTexture, WithoutJitterHasPointsInTheMiddleOfCubes) {
  EXPECT_EQ(Make("voronoi", "jitter 0")->Lookup(Place({2.5f, -0.5f, 0.5f})).x, 0);
  EXPECT_FLOAT_EQ(Make("voronoi", "jitter 0")->Lookup(Place({2, 1, -4})).x, std::sqrt(0.75f));
  const auto edges = Make("voronoi", "jitter 0 feature edges");
  EXPECT_EQ(edges->Lookup(Place({2.5f, -0.5f, 0.5f})).x, 1);
  EXPECT_NEAR(edges->Lookup(Place({3, -0.5f, 0.5f})).x, 0, 1e-6f);
}

TEST(VoronoiTexture, HasANumberForEachCell) {
  const auto cells = Make("voronoi", "jitter 0 feature cells");
  const float here = cells->Lookup(Place({2.1f, 0.2f, 0.3f})).x;
  EXPECT_EQ(cells->Lookup(Place({2.9f, 0.8f, 0.7f})).x, here);
  EXPECT_NE(cells->Lookup(Place({3.1f, 0.8f, 0.7f})).x, here);
  double sum = 0;
  for (int i = 0; i < 10000; ++i)
    sum += static_cast<double>(cells->Lookup(Place(Scattered(i, 99))).x);
  EXPECT_NEAR(sum / 10000, 0.5, 0.01);
}

// What is seen from far away is the mean of what is seen from near.
TEST(VoronoiTexture, FadesToItsMean) {
  for (const char* feature : {"distance", "edges", "cells"}) {
    const auto texture = Make("voronoi", std::string("feature ") + feature);
    double sum = 0;
    for (int i = 0; i < 20000; ++i) {
      sum += static_cast<double>(texture->Lookup(Place(Scattered(i, 77))).x);
    }
    SurfacePoint wide = Place({1, 2, 3});
    wide.footprint = 1;
    EXPECT_NEAR(static_cast<double>(texture->Lookup(wide).x), sum / 20000, 0.01) << feature;
  }
}

TEST(RampTexture, LiesBetweenItsStops) {
  const char* stops = "stops 0 1 0 0 1 0 1 0 3 0 0 2";
  const auto linear = Make("ramp", stops);
  EXPECT_EQ(linear->Lookup(Place({-1, 0, 0})), (Rgb{1, 0, 0}));
  EXPECT_EQ(linear->Lookup(Place({0.25f, 0, 0})), (Rgb{0.75f, 0.25f, 0}));
  EXPECT_EQ(linear->Lookup(Place({2, 0, 0})), (Rgb{0, 0.5f, 1}));
  EXPECT_EQ(linear->Lookup(Place({3, 0, 0})), (Rgb{0, 0, 2}));
  EXPECT_EQ(linear->Lookup(Place({9, 0, 0})), (Rgb{0, 0, 2}));
  const auto smooth = Make("ramp", std::string(stops) + " blend smooth along y");
  EXPECT_EQ(smooth->Lookup(Place({0, 0.25f, 0})), (Rgb{0.84375f, 0.15625f, 0}));
  const auto step = Make("ramp", std::string(stops) + " blend step along z");
  EXPECT_EQ(step->Lookup(Place({0, 0, 0.99f})), (Rgb{1, 0, 0}));
  EXPECT_EQ(step->Lookup(Place({0, 0, 1})), (Rgb{0, 1, 0}));
}

TEST(RampTexture, OfTwoStopsInOnePlaceHasAnEdgeThere) {
  const auto texture = Make("ramp", "stops 0 0 0 0 1 0 0 0 1 1 1 1 2 1 1 1");
  EXPECT_EQ(texture->Lookup(Place({0.999f, 0, 0})).x, 0);
  EXPECT_EQ(texture->Lookup(Place({1, 0, 0})).x, 1);
}

TEST(RampTexture, GoesOnAsItIsTold) {
  const auto at = [](const char* wrap, float x) {
    const auto ramp = Make("ramp", std::string("stops 0 0 0 0 1 1 1 1 wrap ") + wrap);
    return ramp->Lookup(Place({x, 0, 0})).x;
  };
  EXPECT_FLOAT_EQ(at("clamp", 1.25f), 1);
  EXPECT_FLOAT_EQ(at("repeat", 1.25f), 0.25f);
  EXPECT_FLOAT_EQ(at("repeat", -0.25f), 0.75f);
  EXPECT_FLOAT_EQ(at("mirror", 1.25f), 0.75f);
  EXPECT_FLOAT_EQ(at("mirror", -0.25f), 0.25f);
}

TEST(UvTexture, ShowsTheCoordinates) {
  const auto texture = Make("uv", "scale 2 1");
  EXPECT_EQ(texture->Lookup(test::At(0.25f, 0.75f)), (Rgb{0.5f, 0.75f, 0}));
  EXPECT_EQ(texture->Lookup(test::At(0.75f, -0.25f)), (Rgb{0.5f, 0.75f, 0}));
}

TEST(MixTexture, IsTheMeanByItsAmount) {
  const auto texture = Make("mix", "first 1 0 0 second 0 0 2 amount 0.25");
  EXPECT_EQ(texture->Lookup(test::At(0, 0)), (Rgb{0.75f, 0, 0.5f}));
  EXPECT_FALSE(texture->NeedsTextureCoordinates());
}

/// What a pattern that is seen from afar, over a width of `footprint`, shows on a floor whose
/// object is stretched along its axes.
float SeenOnFloor(const std::string& text, Vec3d stretch, float footprint) {
  const auto texture = Make("noise", text);
  const MovingTransform space({Mat4::Scale(stretch)});
  SurfacePoint point = Place({0.3f, 0.6f, 0});
  point.object_space = &space;
  point.footprint = footprint;
  return texture->Lookup(point).x;
}

// The thickness of what lies flat on a surface says nothing of how wide its pattern is there, nor
// does the depth to which the pattern is stretched.
TEST(SolidTexture, ShowsAsMuchOnThinThings) {
  const float seen = SeenOnFloor("", {1, 1, 1}, 0.05f);
  EXPECT_GT(std::abs(seen - 0.5f), 0.02f) << "the pattern has no contrast to lose";
  EXPECT_NEAR(SeenOnFloor("", {1, 1, 1e-3}, 0.05f), seen, 1e-5f);
  EXPECT_NEAR(SeenOnFloor("scale 1 1 1000", {1, 1, 1}, 0.05f), seen, 1e-5f);
}

// Along the surface it does: the direction counts in which the pattern is finest.
TEST(SolidTexture, FadesWhereItIsFineAlongTheSurface) {
  EXPECT_NEAR(SeenOnFloor("", {1, 1e-3, 1}, 0.05f), 0.5f, 1e-5f);
  EXPECT_NEAR(SeenOnFloor("scale 1000 1000 1 rotation 0 0 45", {1, 1, 1}, 0.05f), 0.5f, 1e-5f);
}

}  // namespace
}  // namespace candela
