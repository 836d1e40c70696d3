#include "shapes/mesh.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "geometry/triangle.h"
#include "tests/sampling/chi_square.h"

namespace candela {
namespace {

using test::UniformNumbers;

Mesh MeshOf(MeshSpec spec) {
  return Mesh(std::make_shared<const MeshSpec>(std::move(spec)));
}

/// Two triangles that share the edge from (0, 0, 0) to (0, 1, 0): the right one lies in z = 0 and
/// is twice as large as the left one, which stands upright in x = 0.
MeshSpec Corner(float scale) {
  MeshSpec spec;
  for (const Vec3 p : {Vec3{0, 0, 0}, Vec3{0, 1, 0}, Vec3{2, 0, 0}, Vec3{0, 0, 1}}) {
    spec.positions.push_back(p * scale);
  }
  spec.triangles = {{0, 2, 1}, {0, 1, 3}};
  return spec;
}

SurfacePoint SurfaceSeenBy(const Mesh& mesh, const Ray& ray) {
  HitRecord hit;
  EXPECT_TRUE(mesh.Intersect(ray, &hit));
  return mesh.SurfaceAt(ray, hit);
}

TEST(Mesh, BlendsTheTextureCoordinatesOfItsCorners) {
  MeshSpec spec = Corner(1);
  spec.uvs = {{0, 0}, {4, 0}, {0, 2}};
  spec.uv_corners = {{0, 1, 2}, {0, MeshSpec::kNoUv, 1}};
  const Mesh mesh = MeshOf(std::move(spec));
  const Ray ray({0.5f, 0.25f, 1}, {0, 0, -1});
  HitRecord hit;
  ASSERT_TRUE(mesh.Intersect(ray, &hit));
  SurfacePoint point = mesh.SurfaceAt(ray, hit);
  mesh.AddTextureCoordinates(hit, &point);
  EXPECT_EQ(point.uv, (Vec2{1, 0.5f}));
  EXPECT_EQ(point.dpdu, (Vec3{0.5f, 0, 0}));
  EXPECT_EQ(point.dpdv, (Vec3{0, 0.5f, 0}));
}

TEST(Mesh, OfATriangleWithoutThemTheyArePlacesInIt) {
  MeshSpec spec = Corner(1);
  spec.uvs = {{7, 7}};
  spec.uv_corners = {{0, 0, MeshSpec::kNoUv}, {0, 0, 0}};
  const Mesh mesh = MeshOf(std::move(spec));
  SurfacePoint point;
  HitRecord hit;
  hit.primitive = 0;
  hit.u = 0.25f;
  hit.v = 0.5f;
  mesh.AddTextureCoordinates(hit, &point);
  EXPECT_EQ(point.uv, (Vec2{0.25f, 0.5f}));
}

TEST(Mesh, WithoutTrianglesIsNeverHit) {
  const Mesh mesh = MeshOf({});
  HitRecord hit;
  EXPECT_FALSE(mesh.Intersect(Ray({0, 0, 1}, {0, 0, -1}), &hit));
  EXPECT_FALSE(mesh.Occludes(Ray({0, 0, 1}, {0, 0, -1})));
  EXPECT_TRUE(mesh.ObjectBounds().IsEmpty());
  EXPECT_EQ(mesh.PrimitiveCount(), 0u);
}

TEST(Mesh, OfEqualDistancesTheSmallestIndexWins) {
  MeshSpec spec;
  spec.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  spec.triangles.assign(1000, {0, 1, 2});
  const Mesh mesh = MeshOf(std::move(spec));
  UniformNumbers random(1);
  for (int i = 0; i < 100; ++i) {
    const Vec2 p = random.NextPair() * 0.4f;
    HitRecord hit;
    ASSERT_TRUE(mesh.Intersect(Ray({p.x, p.y, 1 + random.Next()}, {0, 0, -1}), &hit));
    EXPECT_EQ(hit.primitive, 0u);
  }
}

TEST(Mesh, FindsWhatATestOfAllTrianglesFinds) {
  UniformNumbers random(2);
  const auto point = [&] {
    const Vec2 xy = random.NextPair();
    return Vec3{2 * xy.x - 1, 2 * xy.y - 1, 2 * random.Next() - 1};
  };
  MeshSpec spec;
  for (uint32_t i = 0; i < 500; ++i) {
    const Vec3 center = point();
    for (int corner = 0; corner < 3; ++corner) spec.positions.push_back(center + point() * 0.1f);
    spec.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  const Mesh mesh = MeshOf(spec);
  int hits = 0;
  for (int i = 0; i < 20000; ++i) {
    const Vec3 origin = point() * 2;
    const Ray ray(origin, point() - origin);
    HitRecord expected, hit;
    const ShearedRay sheared(ray);
    bool is_hit = false;
    for (uint32_t j = 0; j < spec.triangles.size(); ++j) {
      if (!IntersectTriangle(sheared, 0, spec.positions[3 * j], spec.positions[3 * j + 1],
                             spec.positions[3 * j + 2], &expected)) {
        continue;
      }
      expected.primitive = j;
      is_hit = true;
    }
    ASSERT_EQ(mesh.Intersect(ray, &hit), is_hit);
    ASSERT_EQ(mesh.Occludes(ray), is_hit);
    if (!is_hit) continue;
    ++hits;
    ASSERT_EQ(hit.t, expected.t);
    ASSERT_EQ(hit.primitive, expected.primitive);
  }
  EXPECT_GT(hits, 2000);
}

// The left triangle has half the area of the right one, so at the shared edge the normals (0, 0, 1)
// and (1, 0, 0) count 2 : 1.
TEST(MeshNormals, LargerFacesCountMore) {
  const Mesh mesh = MeshOf(Corner(1));
  const SurfacePoint point = SurfaceSeenBy(mesh, Ray({0, 0, 0.5f}, {0, 0, -1}));
  EXPECT_NEAR(point.n_shading.x, 1 / std::sqrt(5.0f), 1e-7);
  EXPECT_EQ(point.n_shading.y, 0.0f);
  EXPECT_NEAR(point.n_shading.z, 2 / std::sqrt(5.0f), 1e-7);
}

TEST(MeshNormals, TheGeometricNormalIsThatOfTheFace) {
  const Mesh mesh = MeshOf(Corner(1));
  EXPECT_EQ(SurfaceSeenBy(mesh, Ray({0.1f, 0.1f, 1}, {0, 0, -1})).n_geometric, (Vec3{0, 0, 1}));
}

// The cross products of edges of 1e-23 are below the smallest float.
TEST(MeshNormals, TinyTrianglesHaveTheSameOnes) {
  const float scale = 0x1p-76f;
  const Mesh mesh = MeshOf(Corner(scale));
  const SurfacePoint point = SurfaceSeenBy(mesh, Ray(Vec3{0, 0, 0.5f} * scale, {0, 0, -1}));
  EXPECT_NEAR(point.n_shading.x, 1 / std::sqrt(5.0f), 1e-7);
  EXPECT_NEAR(point.n_shading.z, 2 / std::sqrt(5.0f), 1e-7);
}

TEST(MeshNormals, VerticesAtOnePlaceWithDifferentIndicesStayApart) {
  MeshSpec spec = Corner(1);
  spec.positions.push_back(spec.positions[0]);
  spec.positions.push_back(spec.positions[1]);
  spec.triangles = {{0, 2, 1}, {4, 5, 3}};
  const Mesh mesh = MeshOf(std::move(spec));
  EXPECT_EQ(SurfaceSeenBy(mesh, Ray({0.25f, 0.25f, 0.5f}, {0, 0, -1})).n_shading, (Vec3{0, 0, 1}));
}

MeshSpec WithNormals(std::vector<Vec3> normals, MeshSpec::Corners corners) {
  MeshSpec spec;
  spec.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  spec.triangles = {{0, 1, 2}};
  spec.normals = std::move(normals);
  spec.normal_corners = {corners};
  return spec;
}

const Ray kMiddle({0.25f, 0.5f, 1}, {0, 0, -1});  // Weights 1/4, 1/4, 1/2.

TEST(MeshNormals, ThoseOfTheFileAreBlendedAsTheyAre) {
  const Mesh mesh = MeshOf(WithNormals({{4, 0, 0}, {0, 8, 0}, {0, 0, 2}}, {0, 1, 2}));
  EXPECT_EQ(SurfaceSeenBy(mesh, kMiddle).n_shading, (Vec3{1, 2, 1}));
}

TEST(MeshNormals, TheirIndicesAreTheirOwn) {
  const Mesh mesh = MeshOf(WithNormals({{4, 0, 0}, {0, 8, 0}}, {1, 1, 1}));
  EXPECT_EQ(SurfaceSeenBy(mesh, kMiddle).n_shading, (Vec3{0, 8, 0}));
}

TEST(MeshNormals, TinyOnesOfTheFileCount) {
  const Mesh mesh = MeshOf(WithNormals({{0x1p-90f, 0, 0}}, {0, 0, 0}));
  EXPECT_EQ(SurfaceSeenBy(mesh, kMiddle).n_shading, (Vec3{0x1p-90f, 0, 0}));
}

TEST(MeshNormals, ACornerWithoutOneOrWithZeroTakesThatOfTheFace) {
  const uint32_t none = MeshSpec::kNoNormal;
  const Mesh missing = MeshOf(WithNormals({{0, 0, 5}}, {none, none, none}));
  EXPECT_EQ(SurfaceSeenBy(missing, kMiddle).n_shading, (Vec3{0, 0, 1}));
  const Mesh zero = MeshOf(WithNormals({{0, 0, 0}}, {0, 0, 0}));
  EXPECT_EQ(SurfaceSeenBy(zero, kMiddle).n_shading, (Vec3{0, 0, 1}));
}

// Blending three of them would round.
TEST(MeshNormals, WithoutAnyTheNormalIsExactlyThatOfTheFace) {
  const uint32_t none = MeshSpec::kNoNormal;
  MeshSpec spec = WithNormals({}, {none, none, none});
  spec.positions = {{0, 0, 0.3f}, {1, 0, 0.7f}, {0, 1, -0.2f}};
  const Mesh mesh = MeshOf(std::move(spec));
  for (int i = 1; i < 30; ++i) {
    const auto x = static_cast<float>(i) / 30;
    const SurfacePoint point = SurfaceSeenBy(mesh, Ray({x, 0.9f - 0.9f * x, 2}, {0, 0, -1}));
    EXPECT_EQ(point.n_shading, point.n_geometric) << x;
  }
}

/// A square in the plane 3 x + 4 y + 5 z = 0, of two triangles, each with one normal.
MeshSpec Square(Vec3 first, Vec3 second) {
  MeshSpec spec;
  spec.positions = {{0, 0, 0}, {5, 0, -3}, {5, 5, -7}, {0, 5, -4}};
  spec.triangles = {{0, 1, 2}, {0, 2, 3}};
  spec.normals = {first, second};
  spec.normal_corners = {{0, 0, 0}, {1, 1, 1}};
  return spec;
}

const Ray kFirst({4, 1, 9}, {0, 0, -1}), kSecond({1, 4, 9}, {0, 0, -1});

// Flat faces have normals in files as well, with few digits.
TEST(MeshNormals, ThatOnlySayThatFacesAreFlatAreLeftOut) {
  const Mesh mesh = MeshOf(Square({0.4243f, 0.5657f, 0.7071f}, {3, 4, 5}));
  for (const Ray& ray : {kFirst, kSecond}) {
    const SurfacePoint point = SurfaceSeenBy(mesh, ray);
    EXPECT_EQ(point.n_shading, point.n_geometric);
    EXPECT_NEAR(point.n_shading.z, std::sqrt(0.5f), 1e-6f);
  }
}

// What is baked outlives what it was made of.
TEST(MeshNormals, ThatAreLeftOutAreLeftOutOfBakedMeshes) {
  std::shared_ptr<const Shape> baked;
  {
    const Mesh mesh = MeshOf(Square({3, 4, 5}, {3, 4, 5}));
    baked = mesh.Baked(Mat4::Scale({1, 2, 1}));
  }
  HitRecord hit;
  ASSERT_TRUE(baked->Intersect(kFirst, &hit));
  const SurfacePoint point = baked->SurfaceAt(kFirst, hit);
  EXPECT_EQ(point.n_shading, point.n_geometric);
}

TEST(MeshNormals, ThatLeanStayAndSoDoAFewOthers) {
  const Vec3 face{3, 4, 5}, leaning{3, 4, 5.01f};
  const Mesh mesh = MeshOf(Square(leaning, face));
  EXPECT_EQ(SurfaceSeenBy(mesh, kFirst).n_shading, leaning);
  EXPECT_EQ(SurfaceSeenBy(mesh, kSecond).n_shading, face);
  const Mesh inside_out = MeshOf(Square(-face, -face));
  EXPECT_EQ(SurfaceSeenBy(inside_out, kFirst).n_shading, -face);
}

TEST(MeshNormals, OnesThatCancelGiveThatOfTheFace) {
  const Mesh mesh = MeshOf(WithNormals({{1, 0, 0}, {-1, 0, 0}}, {0, 0, 1}));
  EXPECT_EQ(SurfaceSeenBy(mesh, kMiddle).n_shading, (Vec3{0, 0, 1}));
}

}  // namespace
}  // namespace candela
