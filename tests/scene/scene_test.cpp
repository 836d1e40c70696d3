#include "scene/scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <string>

#include "tests/support/compile_text.h"

namespace candela {
namespace {

using testing_support::CompileText;
using testing_support::kCamera;

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();
const Ray kForward({0, 0, 0}, {0, 0, -1});

std::unique_ptr<const Scene> SceneOf(const std::string& nodes) {
  return CompileText(std::string(kCamera) + "Materials { Material { diffuse 1 1 1 } }\nScene { " +
                     nodes + " }");
}

std::string Node(const std::string& transform, const std::string& object) {
  return "Node { Transform { " + transform + " } Component<Object> { " + object +
         " } Component<Material> { index 0 } }\n";
}

const std::string kSphere = "type sphere radius 1";
const std::string kPlane = "type plane normal 0 0 1 offset 0";
const std::string kSquare =
    "type triangle vertex0 -1 -1 0 vertex1 3 -1 0 vertex2 -1 3 0";  // Covers (0, 0).

HitRecord HitOf(const Scene& scene, const Ray& ray = kForward) {
  HitRecord hit;
  EXPECT_TRUE(scene.Intersect(ray, &hit));
  EXPECT_TRUE(hit.IsHit());
  return hit;
}

TEST(SceneIntersect, OfNothingMisses) {
  const auto scene = SceneOf("");
  HitRecord hit;
  EXPECT_FALSE(scene->Intersect(kForward, &hit));
  EXPECT_FALSE(hit.IsHit());
  EXPECT_FALSE(scene->Occluded(kForward));
  EXPECT_TRUE(scene->Bounds().IsEmpty());
}

TEST(SceneIntersect, TheNearestObjectIsFound) {
  const auto scene = SceneOf(Node("translate 0 0 -9", kSphere) + Node("translate 0 0 -5", kSphere) +
                             Node("translate 0 0 -7", kSphere));
  EXPECT_EQ(HitOf(*scene).object, 1u);
  EXPECT_EQ(HitOf(*scene).t, 4.0f);
}

// Bounded or not, whatever the order of the tree: the first in the file.
TEST(SceneIntersect, OfEqualDistancesTheEarlierObjectWins) {
  const std::string square = Node("translate 0 0 -4", kSquare);
  const std::string plane = Node("translate 0 0 -4", kPlane);
  const std::string sphere = Node("translate 0 0 -5", kSphere);
  EXPECT_EQ(HitOf(*SceneOf(square + plane + sphere)).object, 0u);
  EXPECT_EQ(HitOf(*SceneOf(plane + square + sphere)).object, 0u);
  EXPECT_EQ(HitOf(*SceneOf(sphere + square + plane)).object, 0u);

  std::string many;
  for (int i = 0; i < 50; ++i) many += square + sphere;
  EXPECT_EQ(HitOf(*SceneOf(Node("translate 0 0 -9", kSphere) + many + plane)).object, 1u);
}

TEST(SceneIntersect, AMissLeavesTheRecordAsItWas) {
  const auto scene = SceneOf(Node("translate 0 0 -5", kSphere));
  HitRecord hit;
  hit.t = 4, hit.u = 0.25f, hit.v = 0.5f, hit.primitive = 3;
  EXPECT_FALSE(scene->Intersect(kForward, &hit));
  EXPECT_EQ(hit.t, 4.0f);
  EXPECT_EQ(hit.u, 0.25f);
  EXPECT_EQ(hit.v, 0.5f);
  EXPECT_EQ(hit.primitive, 3u);
  EXPECT_FALSE(hit.IsHit());
}

TEST(SceneIntersect, UnboundedObjectsAreFoundBesideTheTree) {
  const auto scene = SceneOf(Node("translate 0 0 -5", kSphere) + Node("translate 0 0 -3", kPlane));
  EXPECT_EQ(HitOf(*scene).object, 1u);
  EXPECT_TRUE(scene->Bounds().IsFinite());
}

TEST(SceneIntersect, RaysThatAreNoRaysMiss) {
  const auto scene = SceneOf(Node("translate 0 0 -5", kSphere) + Node("translate 0 0 -3", kPlane) +
                             Node("", kSquare) + Node("scale 10 10 10", kSphere));
  for (const Ray& ray :
       {Ray({0, 0, 0}, {0, 0, 0}), Ray({0, 0, 0}, {0, 0, kNaN}), Ray({kNaN, 0, 0}, {0, 0, -1}),
        Ray({0, 0, 0}, {0, 0, -kInfinity}), Ray({0, 0, kInfinity}, {0, 0, -1})}) {
    HitRecord hit;
    EXPECT_FALSE(scene->Intersect(ray, &hit));
    EXPECT_FALSE(scene->Occluded(ray));
  }
}

TEST(SceneOccluded, CountsWhatLiesBeforeTheEndOfTheRay) {
  const auto scene = SceneOf(Node("translate 0 0 -5", kSphere) + Node("translate 0 0 -20", kPlane));
  Ray ray = kForward;
  ray.t_max = 4;
  EXPECT_FALSE(scene->Occluded(ray));
  ray.t_max = std::nextafter(4.0f, 5.0f);
  EXPECT_TRUE(scene->Occluded(ray));
  ray.t_min = 7;
  ray.t_max = 20;
  EXPECT_FALSE(scene->Occluded(ray));
  ray.t_max = 21;
  EXPECT_TRUE(scene->Occluded(ray));
}

TEST(SceneIntersect, DistancesCountInUnitsOfTheWorldRay) {
  const auto scene = SceneOf(Node("translate 0 0 -5 scale 2 2 2", kSphere));
  EXPECT_EQ(HitOf(*scene).t, 3.0f);
  EXPECT_EQ(HitOf(*scene, Ray({0, 0, 0}, {0, 0, -2})).t, 1.5f);
}

TEST(SceneIntersect, TheSameMeshMayStandInManyPlaces) {
  const std::string cube = "type mesh obj_file models/cube.obj";
  const auto scene =
      CompileText(std::string(kCamera) + "Materials { Material { } } Scene { " +
                      Node("translate 0 0 -5", cube) + Node("translate 0 0 5", cube) + " }",
                  "assets/assignment4");
  const HitRecord front = HitOf(*scene);
  const HitRecord behind = HitOf(*scene, Ray({0, 0, 0}, {0, 0, 1}));
  EXPECT_EQ(front.object, 0u);
  EXPECT_EQ(behind.object, 1u);
  EXPECT_EQ(front.t, behind.t);
}

// A sphere scaled by (2, 1, 1) at the object point (1/2, 1/2, r): its normal has half the x of the
// object's, not twice.
TEST(SceneSurface, NormalsGoByTheInverseTranspose) {
  const auto scene = SceneOf(Node("scale 2 1 1", kSphere));
  const Ray ray({1, 0.5f, 5}, {0, 0, -1});
  const SurfacePoint point = scene->SurfaceAt(ray, HitOf(*scene, ray));
  const float z = std::sqrt(0.5f);
  const Vec3 expected = Normalize(Vec3{0.25f, 0.5f, z});
  EXPECT_NEAR(point.n_geometric.x, expected.x, 1e-6);
  EXPECT_NEAR(point.n_geometric.y, expected.y, 1e-6);
  EXPECT_NEAR(point.n_geometric.z, expected.z, 1e-6);
  EXPECT_NEAR(point.p.x, 1, 1e-6);
  EXPECT_NEAR(point.p.z, z, 1e-6);
}

TEST(SceneSurface, AMirroredObjectKeepsItsOutside) {
  const auto scene = SceneOf(Node("translate 0 0 -5 scale -1 -1 -1", kSphere));
  EXPECT_EQ(scene->SurfaceAt(kForward, HitOf(*scene)).n_geometric, (Vec3{0, 0, 1}));
}

TEST(SceneSurface, NormalsAreUnitVectorsAtAnyScale) {
  for (const std::string scale : {"1e-30", "1e-20", "1", "1e20", "1e30"}) {
    const auto scene = SceneOf("Node { Transform { scale " + scale + " " + scale + " " + scale +
                               " } " + Node("translate 0 0 -5", kSquare) + " }");
    EXPECT_EQ(scene->SurfaceAt(kForward, HitOf(*scene)).n_geometric, (Vec3{0, 0, 1})) << scale;
  }
}

TEST(SceneSurface, NormalsAreNotTurnedTowardsTheViewer) {
  const auto scene = SceneOf(Node("translate 0 0 -5", "type plane normal 0 0 -1 offset 0"));
  EXPECT_EQ(scene->SurfaceAt(kForward, HitOf(*scene)).n_shading, (Vec3{0, 0, -1}));
}

}  // namespace
}  // namespace candela
