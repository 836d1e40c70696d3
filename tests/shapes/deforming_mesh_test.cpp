#include "shapes/deforming_mesh.h"

#include <gtest/gtest.h>

#include <memory>

#include "tests/sampling/chi_square.h"

namespace candela {
namespace {

using test::UniformNumbers;

/// Two triangles over the unit square, of which one corner is raised.
std::shared_ptr<const MeshSpec> Raised(float height) {
  auto spec = std::make_shared<MeshSpec>();
  spec->positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, height}, {0, 1, 0}};
  spec->triangles = {{0, 1, 2}, {0, 2, 3}};
  spec->uvs = {{0, 0}, {3, 0}, {3, 2}, {0, 2}};
  spec->uv_corners = spec->triangles;
  return spec;
}

// At each time it is the mesh with its vertices in between: hits, points, the true normals, and
// how points move with the texture.
TEST(DeformingMesh, IsAtEachTimeAMeshInBetween) {
  const DeformingMesh mesh(Raised(0), Raised(1));
  EXPECT_TRUE(mesh.IsMoving());
  UniformNumbers random(1);
  for (const float time : {0.0f, 0.25f, 0.5f, 1.0f}) {
    const Mesh rest(Raised(time));
    int hits = 0;
    for (int i = 0; i < 200; ++i) {
      const Vec2 at = random.NextPair();
      Ray ray({at.x, at.y, 3}, {0.01f, 0.02f, -1});
      ray.time = time;
      HitRecord hit, expected;
      const bool is_hit = rest.Intersect(ray, &expected);
      ASSERT_EQ(mesh.Intersect(ray, &hit), is_hit);
      if (!is_hit) continue;
      ++hits;
      ASSERT_EQ(hit.t, expected.t);
      ASSERT_EQ(hit.primitive, expected.primitive);
      SurfacePoint point = mesh.SurfaceAt(ray, hit);
      SurfacePoint expected_point = rest.SurfaceAt(ray, expected);
      point.time = time;
      mesh.AddTextureCoordinates(hit, &point);
      rest.AddTextureCoordinates(expected, &expected_point);
      EXPECT_EQ(point.p, expected_point.p);
      EXPECT_EQ(point.p_error, expected_point.p_error);
      EXPECT_EQ(point.n_geometric, expected_point.n_geometric);
      EXPECT_EQ(point.uv, expected_point.uv);
      EXPECT_EQ(point.dpdu, expected_point.dpdu);
      EXPECT_EQ(point.dpdv, expected_point.dpdv);
      EXPECT_TRUE(mesh.ObjectBounds().Contains(point.p));
    }
    EXPECT_GT(hits, 150) << time;
  }
}

// Normals at the corners go from those of one mesh to those of the other.
TEST(DeformingMesh, BlendsTheNormalsOfItsCorners) {
  const DeformingMesh mesh(Raised(0), Raised(1));
  const Mesh end(Raised(1));
  HitRecord corner;
  corner.primitive = 0;
  corner.u = 1;  // The second vertex.
  Ray ray;
  ray.time = 1;
  EXPECT_EQ(mesh.SurfaceAt(ray, corner).n_shading, end.SurfaceAt(ray, corner).n_shading);
  const Vec3 at_end = end.SurfaceAt(ray, corner).n_shading;
  ray.time = 0.5f;
  EXPECT_EQ(mesh.SurfaceAt(ray, corner).n_shading, (Vec3{0, 0, 1} * 0.5f + at_end * 0.5f));
}

// Those of a file, too, where they only say of one of the meshes that it is flat.
TEST(DeformingMesh, KeepsTheNormalsOfFlatFaces) {
  const auto with_normal = [](Vec3 normal) {
    auto spec = std::make_shared<MeshSpec>();
    spec->positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    spec->triangles = {{0, 1, 2}};
    spec->normals = {normal};
    spec->normal_corners = {{0, 0, 0}};
    return spec;
  };
  const Vec3 flat{0, 0, 2}, leaning{4, 0, 2};
  const DeformingMesh mesh(with_normal(flat), with_normal(leaning));
  HitRecord hit;
  hit.primitive = 0;
  Ray ray;
  for (const float time : {0.0f, 0.5f, 1.0f}) {
    ray.time = time;
    EXPECT_EQ(mesh.SurfaceAt(ray, hit).n_shading, (Vec3{4 * time, 0, 2})) << time;
  }
}

TEST(DeformingMesh, NeedsTheSameFaces) {
  EXPECT_EQ(DeformingMesh::FindDifference(*Raised(0), *Raised(1)), nullptr);
  MeshSpec other = *Raised(1);
  other.triangles[0] = {0, 2, 1};
  EXPECT_NE(DeformingMesh::FindDifference(*Raised(0), other), nullptr);
  other = *Raised(1);
  other.positions.push_back({});
  EXPECT_NE(DeformingMesh::FindDifference(*Raised(0), other), nullptr);
  other = *Raised(1);
  other.normals = {{0, 0, 1}};
  EXPECT_NE(DeformingMesh::FindDifference(*Raised(0), other), nullptr);
}

}  // namespace
}  // namespace candela
