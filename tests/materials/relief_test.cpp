#include "materials/relief.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "materials/diffuse.h"
#include "math/elementary.h"
#include "textures/constant_texture.h"

namespace candela {
namespace {

/// Heights that grow with u and v.
class Slope final : public Texture {
 public:
  Slope(float along_u, float along_v) : along_u_(along_u), along_v_(along_v) {}
  Rgb Lookup(const SurfacePoint& point) const override {
    const float height = along_u_ * point.uv.x + along_v_ * point.uv.y;
    return {height, height, height};
  }

 private:
  float along_u_, along_v_;
};

/// A point of a floor on which u goes along x, two units of length for one of u, and v along -z.
SurfacePoint OnFloor() {
  SurfacePoint point;
  point.n_geometric = point.n_shading = {0, 1, 0};
  point.uv = {0.5f, 0.5f};
  point.dpdu = {2, 0, 0};
  point.dpdv = {0, 0, -1};
  return point;
}

/// The normal that the material bends that of the floor to, seen from above or from below.
Vec3 Bent(std::shared_ptr<const Texture> texture, ReliefMaterial::Map map, float height,
          float side = 1, SurfacePoint point = OnFloor()) {
  const ReliefMaterial material(std::make_unique<DiffuseMaterial>(Rgb{1, 1, 1}), std::move(texture),
                                map, height);
  Bsdf bsdf;
  bsdf.frame = Frame::FromNormal(point.n_shading * side);
  material.Evaluate(point, &bsdf);
  EXPECT_EQ(bsdf.count, 1);
  return bsdf.frame.z;
}

void ExpectNear(Vec3 a, Vec3 b) {
  EXPECT_LE(Length(a - b), 1e-3f) << a.x << " " << a.y << " " << a.z;
}

// Half of each colour is a zero; blue is the way up.
TEST(NormalMap, IsInTheFrameOfTheTextureCoordinates) {
  const auto bent = [](Rgb c, float side = 1) {
    return Bent(std::make_shared<ConstantTexture>(c), ReliefMaterial::Map::kNormals, 0, side);
  };
  ExpectNear(bent({0.5f, 0.5f, 1}), {0, 1, 0});
  ExpectNear(bent({0.8f, 0.5f, 0.9f}), {0.6f, 0.8f, 0});
  ExpectNear(bent({0.5f, 0.8f, 0.9f}), {0, 0.8f, -0.6f});
  ExpectNear(bent({0.8f, 0.5f, 0.9f}, -1), {-0.6f, -0.8f, 0});
}

// The second axis goes where v grows, also where a picture is mirrored.
TEST(NormalMap, FollowsMirroredCoordinates) {
  SurfacePoint point = OnFloor();
  point.dpdv = {0, 0, 1};
  ExpectNear(Bent(std::make_shared<ConstantTexture>(Rgb{0.5f, 0.8f, 0.9f}),
                  ReliefMaterial::Map::kNormals, 0, 1, point),
             {0, 0.8f, 0.6f});
}

// The height grows by 1 for a unit of u, which is 2 long: a slope of 1/2 towards +x.
TEST(BumpMap, TiltsTheNormalAgainstTheSlope) {
  const auto bent = [](float along_u, float along_v, float height, float side = 1) {
    return Bent(std::make_shared<Slope>(along_u, along_v), ReliefMaterial::Map::kHeights, height,
                side);
  };
  ExpectNear(bent(0, 0, 1), {0, 1, 0});
  ExpectNear(bent(1, 0, 1), Normalize(Vec3{-0.5f, 1, 0}));
  ExpectNear(bent(1, 0, 3), Normalize(Vec3{-1.5f, 1, 0}));
  ExpectNear(bent(0, 1, 1), Normalize(Vec3{0, 1, 1}));
  ExpectNear(bent(1, 0, 1, -1), Normalize(Vec3{0.5f, -1, 0}));
}

/// Heights that go up and down in space, over lengths of about 1.
class Waves final : public Texture {
 public:
  Rgb Lookup(const SurfacePoint& point) const override {
    const float height = Sin(3 * point.p.x) + Sin(2 * point.p.z);
    return {height, height, height};
  }
};

// What fills space has its slopes, however large the triangle is that the coordinates come from,
// and where there are no coordinates.
TEST(BumpMap, OfASolidTextureDoesNotAskHowTheSurfaceIsCut) {
  SurfacePoint point = OnFloor();
  point.p = {0.2f, 0, 0.1f};
  point.footprint = 0.01f;
  const Vec3 expected = Normalize(Vec3{-3 * Cos(0.6f), 1, -2 * Cos(0.2f)});
  for (const float size : {0.0f, 1e-4f, 1.0f, 1e4f}) {
    point.dpdu = {size, 0, size};
    point.dpdv = {0, 0, -size};
    ExpectNear(Bent(std::make_shared<Waves>(), ReliefMaterial::Map::kHeights, 1, 1, point),
               expected);
  }
}

// Coordinates that are no right angle to each other, and of unequal length.
TEST(BumpMap, FollowsSlantedCoordinates) {
  SurfacePoint point = OnFloor();
  point.dpdv = {1, 0, -1};
  const auto slope = std::make_shared<Slope>(0.5f, 0.7f);
  const Vec3 by_uv = Bent(slope, ReliefMaterial::Map::kHeights, 1, 1, point);
  point.footprint = 0.01f;
  ExpectNear(Bent(slope, ReliefMaterial::Map::kHeights, 1, 1, point), by_uv);
}

TEST(BumpMap, BendsNothingWhereCoordinatesSayNothing) {
  SurfacePoint point = OnFloor();
  point.dpdu = point.dpdv = {0, 0, 0};
  ExpectNear(Bent(std::make_shared<Slope>(1.0f, 1.0f), ReliefMaterial::Map::kHeights, 1, 1, point),
             {0, 1, 0});
}

}  // namespace
}  // namespace candela
