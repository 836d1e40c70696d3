// What Embree's robust mode hits is hit, and what it misses is missed.
#include <embree3/rtcore.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "math/elementary.h"
#include "tests/kernel/group_description.h"
#include "tests/kernel/trace_lists.h"
#include "tests/support/effort.h"

namespace candela::test {
namespace {

/// A scene of Embree with one mesh, in its robust mode.
class EmbreeScene {
 public:
  explicit EmbreeScene(const TestMesh& mesh)
      : device_(rtcNewDevice(nullptr)), scene_(rtcNewScene(device_)) {
    rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);
    const RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
    void* const positions =
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                sizeof(Vec3), mesh.positions.size());
    std::copy(mesh.positions.begin(), mesh.positions.end(), static_cast<Vec3*>(positions));
    void* const triangles =
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                sizeof(mesh.triangles[0]), mesh.triangles.size());
    std::copy(mesh.triangles.begin(), mesh.triangles.end(),
              static_cast<std::array<uint32_t, 3>*>(triangles));
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene_, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene_);
  }
  ~EmbreeScene() {
    rtcReleaseScene(scene_);
    rtcReleaseDevice(device_);
  }
  EmbreeScene(const EmbreeScene&) = delete;
  EmbreeScene& operator=(const EmbreeScene&) = delete;

  bool Intersect(const Ray& ray, HitRecord* hit) const {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    RTCRayHit query{};
    query.ray.org_x = ray.origin.x, query.ray.org_y = ray.origin.y, query.ray.org_z = ray.origin.z;
    query.ray.dir_x = ray.direction.x, query.ray.dir_y = ray.direction.y;
    query.ray.dir_z = ray.direction.z;
    query.ray.tnear = ray.t_min;
    query.ray.tfar = ray.t_max;
    query.ray.mask = 0xFFFFFFFF;
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(scene_, &context, &query);
    if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return false;
    hit->t = query.ray.tfar;
    hit->primitive = query.hit.primID;
    return true;
  }

 private:
  RTCDevice device_;
  RTCScene scene_;
};

/// A closed box with bumpy walls, and displaced spheres in it: 105,600 triangles.
TestMesh Room() {
  UniformNumbers random(1);
  TestMesh walls = GridCube(60);
  for (Vec3& p : walls.positions) {
    const Vec3 bump{Sin(13 * p.y) * Cos(17 * p.z), Sin(11 * p.z) * Cos(19 * p.x),
                    Sin(12 * p.x) * Cos(15 * p.y)};
    p += bump * 0.02f;
  }
  std::vector<TestMesh> all = {walls};
  for (int i = 0; i < 30; ++i) {
    const Vec3 center = RandomPoint(&random) * 0.8f;
    all.push_back(Moved(BumpyGlobe(24, 43, 0.1f, &random), 0.02f + 0.2f * random.Next(), center));
  }
  return Join(all);
}

/// Closed tubes with three sides that wind about: 100,000 triangles.
TestMesh Hairball() {
  UniformNumbers random(2);
  TestMesh hairball;
  constexpr uint32_t kTubes = 1000, kRings = 17;
  for (uint32_t tube = 0; tube < kTubes; ++tube) {
    const auto first = static_cast<uint32_t>(hairball.positions.size());
    Vec3d center = ToDouble(RandomPoint(&random) * 0.3f);
    Vec3d along = Normalize(ToDouble(RandomPoint(&random)));
    for (uint32_t ring = 0; ring < kRings; ++ring) {
      const Vec3d x = Normalize(Cross(along, Vec3d{0.3, 0.5, 0.8})), y = Cross(along, x);
      for (int side = 0; side < 3; ++side) {
        const double turn = 2 * kPi * side / 3;
        hairball.positions.push_back(ToFloat(center + (x * Cos(turn) + y * Sin(turn)) * 0.003));
      }
      center += along * 0.05;
      along = Normalize(along + ToDouble(RandomPoint(&random)) * 0.4);
    }
    hairball.triangles.push_back({first, first + 2, first + 1});
    for (uint32_t ring = 0; ring + 1 < kRings; ++ring) {
      for (uint32_t side = 0; side < 3; ++side) {
        const uint32_t a = first + 3 * ring + side, b = first + 3 * ring + (side + 1) % 3;
        hairball.triangles.push_back({a, b, b + 3});
        hairball.triangles.push_back({a, b + 3, a + 3});
      }
    }
    const uint32_t last = first + 3 * (kRings - 1);
    hairball.triangles.push_back({last, last + 1, last + 2});
  }
  return hairball;
}

constexpr size_t kRays = testing_support::kIsSanitized ? 10'000 : 1'000'000;

/// Half of them from a point outside or inside, in bundles; half from anywhere to anywhere.
std::vector<Ray> RaysThrough(float reach, UniformNumbers* random) {
  std::vector<Ray> rays;
  while (rays.size() < kRays) {
    const Vec3 origin = RandomPoint(random) * reach;
    const Vec3 direction = RandomPoint(random) * 0.9f - origin;
    const int count = rays.size() % 32 == 0 ? 16 : 1;
    for (int i = 0; i < count; ++i) {
      rays.emplace_back(origin, direction + RandomPoint(random) * (count == 1 ? 0.0f : 0.02f));
    }
  }
  return rays;
}

/// How near a ray comes to an edge of the mesh.
double DistanceToEdges(const TestMesh& mesh, const Ray& ray) {
  const Vec3d o = ToDouble(ray.origin), d = Normalize(ToDouble(ray.direction));
  double least = 1e30;
  for (const auto& triangle : mesh.triangles) {
    for (size_t i = 0; i < 3; ++i) {
      const Vec3d p = ToDouble(mesh.positions[triangle[i]]) - o;
      const Vec3d edge = ToDouble(mesh.positions[triangle[(i + 1) % 3]]) - o - p;
      // Without what lies along the ray, in the plane across it: the distance of a segment from 0.
      const Vec3d a = p - d * Dot(p, d), along = edge - d * Dot(edge, d);
      const double part = std::clamp(-Dot(a, along) / LengthSquared(along), 0.0, 1.0);
      least = std::min(least, Length(a + along * part));
    }
  }
  return least;
}

/// At most `most_differ` rays may hit in one and miss in the other: those that touch an edge of a
/// silhouette within rounding.
void ExpectSameHits(const TestMesh& mesh, float reach, size_t most_differ) {
  UniformNumbers random(3);
  const std::vector<Ray> rays = RaysThrough(reach, &random);
  const EmbreeScene embree(mesh);
  std::vector<HitRecord> right(rays.size());
  size_t hit_count = 0;
  for (size_t i = 0; i < rays.size(); ++i) hit_count += embree.Intersect(rays[i], &right[i]);
  for (const BuildQuality quality : {BuildQuality::kFast, BuildQuality::kBest}) {
    BuildOptions options;
    options.quality = quality;
    const auto group = MustBuild(OfMesh(mesh), options);
    for (const Entry entry : kEntries) {
      const auto hits = IntersectList(*group, entry, rays);
      const auto occluded = OccludedList(*group, entry, rays);
      size_t differ = 0, farther = 0, other = 0;
      for (size_t i = 0; i < rays.size(); ++i) {
        const bool is_hit = right[i].t < rays[i].t_max;
        if (hits[i].IsHit() != is_hit) {
          ++differ;
          EXPECT_LT(DistanceToEdges(mesh, rays[i]), 2e-7) << ToString(rays[i]);
        }
        EXPECT_EQ(occluded[i] != 0, hits[i].IsHit());
        if (!is_hit || !hits[i].IsHit()) continue;
        farther += std::abs(hits[i].t - right[i].t) > 1e-3f * right[i].t;
        other += hits[i].primitive != right[i].primitive;
      }
      EXPECT_LE(differ, most_differ) << ToString(options) << ", " << ToString(entry);
      std::printf(
          "%s, %s: %zu of %zu rays hit, %zu differ; %zu at another distance, %zu another "
          "triangle\n",
          ToString(options).c_str(), ToString(entry).c_str(), hit_count, rays.size(), differ,
          farther, other);
      // Beside an edge of a silhouette one of two surfaces is hit.
      EXPECT_LE(farther, rays.size() / 100'000) << ToString(options) << ", " << ToString(entry);
    }
  }
}

TEST(Embree, HitsTheSameInARoom) {
  ExpectSameHits(Room(), 0.95f, 0);
}

// Thin tubes are all silhouette: 5 of 1e6 rays touch an edge.
TEST(Embree, HitsTheSameInAHairball) {
  ExpectSameHits(Hairball(), 2, kRays / 100'000);
}

}  // namespace
}  // namespace candela::test
