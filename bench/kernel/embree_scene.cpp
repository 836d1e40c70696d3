#include "embree_scene.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/check.h"

namespace candela {
namespace {

constexpr size_t kPacket = 16;

RTCRay MakeRay(const Ray& ray) {
  return {ray.origin.x,
          ray.origin.y,
          ray.origin.z,
          ray.t_min,
          ray.direction.x,
          ray.direction.y,
          ray.direction.z,
          ray.time,
          ray.t_max,
          ray.mask,
          0,
          0};
}

RTCRayHit MakeQuery(const Ray& ray) {
  RTCRayHit query;
  query.ray = MakeRay(ray);
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  return query;
}

/// What stands for lane i of a packet. Lanes without a ray are switched off.
void SetRay(const Ray& ray, size_t i, RTCRay16* packet) {
  packet->org_x[i] = ray.origin.x;
  packet->org_y[i] = ray.origin.y;
  packet->org_z[i] = ray.origin.z;
  packet->tnear[i] = ray.t_min;
  packet->dir_x[i] = ray.direction.x;
  packet->dir_y[i] = ray.direction.y;
  packet->dir_z[i] = ray.direction.z;
  packet->time[i] = ray.time;
  packet->tfar[i] = ray.t_max;
  packet->mask[i] = ray.mask;
  packet->flags[i] = 0;
}

/// The record of a hit that was found. Instances count as objects, as with us.
void SetHit(float t, float u, float v, unsigned geometry, unsigned instance, unsigned primitive,
            HitRecord* hit) {
  hit->t = t;
  hit->u = u;
  hit->v = v;
  hit->primitive = primitive;
  hit->object = geometry;
  if (instance != RTC_INVALID_GEOMETRY_ID) {
    hit->object = instance;
    hit->nested[0] = geometry;
  }
}

RTCIntersectContext MakeContext(RTCIntersectContextFlags flags) {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = flags;
  return context;
}

/// Calls `body(first ray, number of rays, valid lanes)` for each packet.
template <class Body>
void ForPackets(size_t count, const Body& body) {
  alignas(64) int valid[kPacket];
  for (size_t begin = 0; begin < count; begin += kPacket) {
    const size_t size = std::min(kPacket, count - begin);
    for (size_t i = 0; i < kPacket; ++i) valid[i] = i < size ? -1 : 0;
    body(begin, size, valid);
  }
}

}  // namespace

EmbreeDevice::EmbreeDevice(int threads, const std::string& max_isa) {
  std::string config = fmt::format("threads={}", threads);
  if (!max_isa.empty()) config += ",max_isa=" + max_isa;
  device_ = rtcNewDevice(config.c_str());
  CHECK(device_ != nullptr);
  const auto fail = [](void*, RTCError, const char* message) {
    fmt::print(stderr, "Embree: {}\n", message);
    CHECK(!"Embree can go on");
  };
  rtcSetDeviceErrorFunction(device_, fail, nullptr);
  const auto count = [](void* bytes, ssize_t change, bool) {
    *static_cast<std::atomic<int64_t>*>(bytes) += change;
    return true;
  };
  rtcSetDeviceMemoryMonitorFunction(device_, count, &bytes_);
}

EmbreeDevice::~EmbreeDevice() {
  rtcReleaseDevice(device_);
}

EmbreeScene::EmbreeScene(const EmbreeDevice& device, const BenchScene& scene, Quality quality,
                         bool is_robust)
    : device_(device.handle()) {
  const int64_t before = device.MemoryBytes();
  scene_ = NewScene(quality, is_robust);
  Attach(scene.mesh, scene_);
  if (!scene.instances.empty()) {
    part_ = NewScene(quality, is_robust);
    Attach(scene.part, part_);
    rtcCommitScene(part_);
    for (const Mat4& world_from_part : scene.instances) AttachInstance(world_from_part);
  }
  rtcCommitScene(scene_);
  bytes_ = device.MemoryBytes() - before;
}

EmbreeScene::~EmbreeScene() {
  rtcReleaseScene(scene_);
  if (part_ != nullptr) rtcReleaseScene(part_);
}

RTCScene EmbreeScene::NewScene(Quality quality, bool is_robust) const {
  constexpr RTCBuildQuality kQualities[] = {RTC_BUILD_QUALITY_LOW, RTC_BUILD_QUALITY_MEDIUM,
                                            RTC_BUILD_QUALITY_HIGH};
  const RTCScene scene = rtcNewScene(device_);
  rtcSetSceneBuildQuality(scene, kQualities[static_cast<size_t>(quality)]);
  rtcSetSceneFlags(scene, is_robust ? RTC_SCENE_FLAG_ROBUST : RTC_SCENE_FLAG_NONE);
  return scene;
}

void EmbreeScene::Attach(const TriangleMesh& mesh, RTCScene scene) const {
  // Embree reads 16 bytes of each vertex, also of the last one.
  CHECK(mesh.positions.capacity() > mesh.positions.size());
  const RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
  rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                             mesh.positions.data(), 0, sizeof(Vec3), mesh.positions.size());
  rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                             mesh.triangles.data(), 0, sizeof(mesh.triangles[0]),
                             mesh.triangles.size());
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(scene, geometry);
  rtcReleaseGeometry(geometry);
}

void EmbreeScene::AttachInstance(const Mat4& world_from_part) const {
  float rows[12];
  for (size_t i = 0; i < 12; ++i) rows[i] = static_cast<float>(world_from_part.m[i / 4][i % 4]);
  const RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_INSTANCE);
  rtcSetGeometryInstancedScene(geometry, part_);
  rtcSetGeometryTransform(geometry, 0, RTC_FORMAT_FLOAT3X4_ROW_MAJOR, rows);
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(scene_, geometry);
  rtcReleaseGeometry(geometry);
}

void EmbreeScene::Intersect(std::span<const Ray> rays, std::span<HitRecord> hits) const {
  RTCIntersectContext context = MakeContext(RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT);
  for (size_t i = 0; i < rays.size(); ++i) {
    RTCRayHit query = MakeQuery(rays[i]);
    rtcIntersect1(scene_, &context, &query);
    if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) continue;
    SetHit(query.ray.tfar, query.hit.u, query.hit.v, query.hit.geomID, query.hit.instID[0],
           query.hit.primID, &hits[i]);
  }
}

void EmbreeScene::Occluded(std::span<const Ray> rays, std::span<uint8_t> occluded) const {
  RTCIntersectContext context = MakeContext(RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT);
  for (size_t i = 0; i < rays.size(); ++i) {
    RTCRay query = MakeRay(rays[i]);
    rtcOccluded1(scene_, &context, &query);
    occluded[i] = query.tfar < 0;
  }
}

void EmbreeScene::IntersectPackets(std::span<const Ray> rays, std::span<HitRecord> hits) const {
  RTCIntersectContext context = MakeContext(RTC_INTERSECT_CONTEXT_FLAG_COHERENT);
  RTCRayHit16 query = {};
  ForPackets(rays.size(), [&](size_t begin, size_t size, const int* valid) {
    for (size_t i = 0; i < size; ++i) {
      SetRay(rays[begin + i], i, &query.ray);
      query.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
      query.hit.instID[0][i] = RTC_INVALID_GEOMETRY_ID;
    }
    rtcIntersect16(valid, scene_, &context, &query);
    for (size_t i = 0; i < size; ++i) {
      if (query.hit.geomID[i] == RTC_INVALID_GEOMETRY_ID) continue;
      SetHit(query.ray.tfar[i], query.hit.u[i], query.hit.v[i], query.hit.geomID[i],
             query.hit.instID[0][i], query.hit.primID[i], &hits[begin + i]);
    }
  });
}

void EmbreeScene::OccludedPackets(std::span<const Ray> rays, std::span<uint8_t> occluded) const {
  // With instances, and said to be coherent, rtcOccluded16 of Embree 3.13.5 may never return.
  RTCIntersectContext context = MakeContext(part_ != nullptr ? RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT
                                                             : RTC_INTERSECT_CONTEXT_FLAG_COHERENT);
  RTCRay16 query = {};
  ForPackets(rays.size(), [&](size_t begin, size_t size, const int* valid) {
    for (size_t i = 0; i < size; ++i) SetRay(rays[begin + i], i, &query);
    rtcOccluded16(valid, scene_, &context, &query);
    for (size_t i = 0; i < size; ++i) occluded[begin + i] = query.tfar[i] < 0;
  });
}

std::optional<SurfaceHit> EmbreeScene::FindSurface(const Ray& ray) const {
  RTCIntersectContext context = MakeContext(RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT);
  RTCRayHit query = MakeQuery(ray);
  rtcIntersect1(scene_, &context, &query);
  if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
  Vec3 n = {query.hit.Ng_x, query.hit.Ng_y, query.hit.Ng_z};
  if (query.hit.instID[0] != RTC_INVALID_GEOMETRY_ID) {
    // As good as the inverse transposed: instances are scaled alike in all directions.
    float rows[12];
    rtcGetGeometryTransform(rtcGetGeometry(scene_, query.hit.instID[0]), 0,
                            RTC_FORMAT_FLOAT3X4_ROW_MAJOR, rows);
    n = {Dot(Vec3{rows[0], rows[1], rows[2]}, n), Dot(Vec3{rows[4], rows[5], rows[6]}, n),
         Dot(Vec3{rows[8], rows[9], rows[10]}, n)};
  }
  n = NormalizeAnyLength(n);
  return SurfaceHit{ray.At(query.ray.tfar), Dot(n, ray.direction) < 0 ? n : -n};
}

}  // namespace candela
