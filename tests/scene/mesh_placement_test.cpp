// A mesh that one object has is moved into the world; one that several have is instanced. Nobody
// should see which.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "sampling/warp.h"
#include "scene/compile_scene.h"
#include "tests/kernel/test_mesh.h"
#include "tests/sampling/chi_square.h"

namespace candela {
namespace {

using test::TestMesh;
using test::UniformNumbers;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

std::shared_ptr<MeshSpec> SpecOf(const TestMesh& mesh) {
  auto spec = std::make_shared<MeshSpec>();
  spec->positions = mesh.positions;
  spec->triangles = mesh.triangles;
  return spec;
}

/// Normals of the file: of different lengths, some of them 0, some missing.
std::shared_ptr<MeshSpec> WithOddNormals(const TestMesh& mesh) {
  auto spec = SpecOf(mesh);
  UniformNumbers random(7);
  for (const Vec3 p : mesh.positions) spec->normals.push_back(p * (0.5f + 2 * random.Next()));
  spec->normals.push_back({0, 0, 0});
  for (MeshSpec::Corners corners : mesh.triangles) {
    for (uint32_t& corner : corners) {
      const float chance = random.Next();
      if (chance < 0.2f) corner = MeshSpec::kNoNormal;
      if (chance > 0.9f) corner = static_cast<uint32_t>(mesh.positions.size());
    }
    spec->normal_corners.push_back(corners);
  }
  return spec;
}

NodeSpec NodeOf(const std::string& mesh, const Mat4& matrix) {
  NodeSpec node;
  node.parent_from_node = matrix;
  node.object = TypedSpec{"mesh", {}, {{{"obj_file", {}, {{mesh, {}}}}}}};
  node.material = MaterialReference{{}, 0, {}};
  return node;
}

SceneSpec SpecWith(std::shared_ptr<const MeshSpec> mesh, const std::vector<Mat4>& places) {
  SceneSpec spec;
  spec.materials.push_back({TypedSpec{"phong", {}, {}}, {}, {}});
  spec.meshes["mesh"] = std::move(mesh);
  for (const Mat4& place : places) spec.nodes.push_back(NodeOf("mesh", place));
  return spec;
}

std::unique_ptr<Scene> Compile(const SceneSpec& spec, std::vector<std::string>* lines = nullptr) {
  Diagnostics diagnostics;
  auto scene = CompileScene(spec, &diagnostics);
  if (lines) {
    *lines = diagnostics.Lines();
  } else {
    EXPECT_THAT(diagnostics.Lines(), IsEmpty());
  }
  return scene;
}

struct Place {
  const char* name;
  Mat4 matrix;
};

std::vector<Place> Places() {
  const Mat4 turned = Mat4::Rotate(0, 30) * Mat4::Rotate(1, -70);
  const Mat4 moved = Mat4::Translate({3, -2, 5});
  return {
      {"moved", moved},
      {"turned", moved * turned},
      {"stretched", turned * Mat4::Scale({3, 0.2, 1})},
      {"sheared", Mat4::Scale({2, 1, 1}) * Mat4::Rotate(2, 40)},
      {"mirrored", moved * Mat4::Scale({-1, 1, 1})},
      {"inverted", turned * Mat4::Scale({-2, -1, -0.5})},
      {"mirrored twice", Mat4::Scale({-1, -1, 1})},
      {"tiny", Mat4::Scale({1e-12, 1e-12, 1e-12}) * turned},
      {"huge", Mat4::Scale({1e12, 1e12, 1e12}) * turned},
  };
}

/// Rays towards the mesh, in the world.
Ray RandomRay(const Transform& world_from_mesh, UniformNumbers* random) {
  const Vec3 origin = SampleUniformSphere(random->NextPair()) * 3;
  const Vec3 target = SampleUniformSphere(random->NextPair()) * 0.7f;
  return {world_from_mesh.Point(origin), world_from_mesh.Vector(target - origin)};
}

/// Both scenes show the same: the mesh is the first object of each.
void ExpectSame(const Scene& baked, const Scene& instanced, const Mat4& place) {
  ASSERT_FALSE(baked.objects()[0].is_instance);
  ASSERT_TRUE(instanced.objects()[0].is_instance);
  UniformNumbers random(3);
  int hits = 0, different = 0;
  for (int i = 0; i < 3000; ++i) {
    const Ray ray = RandomRay(Transform(place), &random);
    HitRecord ours, theirs;
    baked.Intersect(ray, &ours);
    instanced.Intersect(ray, &theirs);
    EXPECT_EQ(baked.Occluded(ray), ours.IsHit());
    EXPECT_EQ(instanced.Occluded(ray), theirs.IsHit());
    if (!ours.IsHit() && !theirs.IsHit()) continue;
    ++hits;
    if (ours.object != theirs.object || ours.primitive != theirs.primitive) {
      ++different;  // At an edge rounding decides.
      continue;
    }
    EXPECT_NEAR(ours.t, theirs.t, 1e-4);
    const SurfacePoint a = baked.SurfaceAt(ray, ours), b = instanced.SurfaceAt(ray, theirs);
    EXPECT_LE(Length(a.n_geometric - b.n_geometric), 1e-4);
    EXPECT_LE(Length(a.n_shading - b.n_shading), 3e-3);
    EXPECT_LE(Length(baked.ShadingAt(ray, ours).n_shading - a.n_shading), 1e-6);
  }
  EXPECT_GT(hits, 1000);
  EXPECT_LT(different, 20);
}

TEST(MeshPlacement, BakedAndInstancedLookTheSame) {
  const TestMesh star = test::Star(24, 48, 5);
  for (const Place& place : Places()) {
    SCOPED_TRACE(place.name);
    const Mat4 elsewhere = Mat4::Translate({1000, 0, 0}) * place.matrix;
    for (const auto& mesh : {SpecOf(star), WithOddNormals(star)}) {
      ExpectSame(*Compile(SpecWith(mesh, {place.matrix})),
                 *Compile(SpecWith(mesh, {place.matrix, elsewhere})), place.matrix);
    }
  }
}

TEST(MeshPlacement, SmallMeshesAreCopiedRatherThanShared) {
  const auto mesh = SpecOf(test::BoxMesh({-1, -1, -1}, {1, 1, 1}));
  const auto scene =
      Compile(SpecWith(mesh, {Mat4::Translate({0, 0, -9}), Mat4::Translate({0, 0, 9})}));
  ASSERT_THAT(scene->objects(), SizeIs(2));
  EXPECT_FALSE(scene->objects()[0].is_instance);
  HitRecord hit;
  ASSERT_TRUE(scene->Intersect(Ray({0.25f, 0.5f, 0}, {0, 0, 1}), &hit));
  EXPECT_EQ(hit.object, 1u);
  EXPECT_EQ(hit.t, 8.0f);
}

/// A triangle in the plane z = 0 that faces +z and covers (0, 0).
std::shared_ptr<MeshSpec> Facet(float size = 1) {
  auto spec = std::make_shared<MeshSpec>();
  spec->positions = {Vec3{-1, -1, 0} * size, Vec3{3, -1, 0} * size, Vec3{-1, 3, 0} * size};
  spec->triangles = {{0, 1, 2}};
  return spec;
}

Vec3 NormalSeenFrom(const Scene& scene, float z) {
  const Ray ray({0, 0, z}, {0, 0, z > 0 ? -1.0f : 1.0f});
  HitRecord hit;
  EXPECT_TRUE(scene.Intersect(ray, &hit));
  const SurfacePoint point = scene.SurfaceAt(ray, hit);
  EXPECT_EQ(point.n_geometric, point.n_shading);
  return point.n_geometric;
}

TEST(MeshPlacement, AMirroredSurfaceKeepsItsOutside) {
  EXPECT_EQ(NormalSeenFrom(*Compile(SpecWith(Facet(), {Mat4::Scale({-1, 1, 1})})), 5),
            (Vec3{0, 0, 1}));
  EXPECT_EQ(NormalSeenFrom(*Compile(SpecWith(Facet(), {Mat4::Scale({1, 1, -1})})), 5),
            (Vec3{0, 0, -1}));
  EXPECT_EQ(NormalSeenFrom(*Compile(SpecWith(Facet(), {Mat4::Rotate(1, 180)})), 5),
            (Vec3{0, 0, -1}));
}

// The normal of the corner at (0, 0) leans by 45 degrees; the others have that of the face. Under a
// scale of 2 along x the face's (0, 0, 1) stays and (1, 0, 1) becomes (1/2, 0, 1); half-way between
// the two, lengths as they are in the object.
TEST(MeshPlacement, AMissingNormalCountsAsTheUnitNormalOfTheFace) {
  auto mesh = std::make_shared<MeshSpec>();
  mesh->positions = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
  mesh->triangles = {{0, 1, 2}};
  mesh->normals = {{1, 0, 1}};
  mesh->normal_corners = {{0, MeshSpec::kNoNormal, MeshSpec::kNoNormal}};
  const auto scene = Compile(SpecWith(mesh, {Mat4::Scale({2, 1, 1})}));
  const Ray ray({2, 1, 5}, {0, 0, -1});  // Weights 1/2, 1/4 and 1/4.
  HitRecord hit;
  ASSERT_TRUE(scene->Intersect(ray, &hit));
  const Vec3 n = scene->SurfaceAt(ray, hit).n_shading;
  const Vec3 expected = Normalize(Vec3{0.25f, 0, 1});
  EXPECT_NEAR(n.x, expected.x, 1e-6);
  EXPECT_NEAR(n.z, expected.z, 1e-6);
}

TEST(MeshPlacement, NormalsSurviveAnyScale) {
  auto mesh = Facet();
  for (const float length : {0x1p-120f, 1.0f, 0x1p120f}) {
    mesh->normals = {{length, 0, length}};
    mesh->normal_corners = {{0, 0, 0}};
    for (const double scale : {1e-30, 1e-5, 1e5, 1e30}) {
      SCOPED_TRACE(testing::Message() << length << " " << scale);
      const auto scene = Compile(SpecWith(mesh, {Mat4::Scale({scale, scale, scale})}));
      const auto size = static_cast<float>(scale);
      const Ray ray({0, 0, size}, {0, 0, -1});
      HitRecord hit;
      ASSERT_TRUE(scene->Intersect(ray, &hit));
      const Vec3 n = scene->SurfaceAt(ray, hit).n_shading;
      EXPECT_NEAR(n.x, std::sqrt(0.5f), 1e-6);
      EXPECT_NEAR(n.z, std::sqrt(0.5f), 1e-6);
    }
  }
}

TEST(MeshPlacement, TrianglesThatDoNotFitAreLeftOut) {
  SceneSpec spec = SpecWith(Facet(2e38f), {Mat4::Scale({2, 2, 2})});
  spec.file.file = std::make_shared<const std::string>("s");
  spec.nodes[0].transform_where = {spec.file.file, 3, 7};
  spec.meshes["facet"] = Facet();
  spec.nodes.push_back(NodeOf("facet", Mat4::Translate({0, 0, -4})));
  std::vector<std::string> lines;
  const auto scene = Compile(spec, &lines);
  EXPECT_THAT(lines, ElementsAre("s:3:7: warning: the object is left out: its triangles are too "
                                 "far away or too large for single precision"));
  ASSERT_THAT(scene->objects(), SizeIs(1));
  HitRecord hit;
  ASSERT_TRUE(scene->Intersect(Ray({0, 0, 0}, {0, 0, -1}), &hit));
  EXPECT_EQ(hit.object, 0u);
  EXPECT_EQ(hit.t, 4.0f);
}

TEST(MeshPlacement, ThousandsOfObjectsShareOneCopy) {
  const auto mesh = SpecOf(test::CurvedGrid(220, 0.1f));  // 96,800 triangles.
  std::vector<Mat4> places;
  for (int i = 0; i < 10'000; ++i) places.push_back(Mat4::Translate({3.0 * i, 0, 0}));
  const auto two = Compile(SpecWith(mesh, {places[0], places[1]}));
  const auto many = Compile(SpecWith(mesh, places));
  ASSERT_THAT(many->objects(), SizeIs(10'000));
  EXPECT_EQ(many->objects()[17].shape, many->objects()[0].shape);
  EXPECT_THAT(many->tree().mesh_groups, SizeIs(1));
  EXPECT_LT(many->MemoryBytes(), two->MemoryBytes() + 10'000 * 1000);

  HitRecord hit;
  ASSERT_TRUE(many->Intersect(Ray({3.0f * 9000 + 0.25f, 5, 0.25f}, {0, -1, 0}), &hit));
  EXPECT_EQ(hit.object, 9000u);
}

}  // namespace
}  // namespace candela
