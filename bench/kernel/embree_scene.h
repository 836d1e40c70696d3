#pragma once

#include <embree3/rtcore.h>

#include <atomic>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "bench_scene.h"
#include "geometry/hit_record.h"
#include "geometry/ray.h"

namespace candela {

/// Embree itself: its threads and its memory.
class EmbreeDevice {
 public:
  /// `max_isa` is "avx2" and the like; empty for the best there is.
  EmbreeDevice(int threads, const std::string& max_isa);
  ~EmbreeDevice();
  EmbreeDevice(const EmbreeDevice&) = delete;
  EmbreeDevice& operator=(const EmbreeDevice&) = delete;

  RTCDevice handle() const { return device_; }
  /// What it holds at this moment, as it says itself.
  int64_t MemoryBytes() const { return bytes_; }

 private:
  RTCDevice device_;
  std::atomic<int64_t> bytes_ = 0;
};

/// Where a ray hits, for paths.
struct SurfaceHit {
  Vec3 p;
  Vec3 n;  ///< Of the plane of the triangle, unit, against the ray.
};

/// A scene in Embree. Answers are given in our terms, in the way of a program that is written
/// around Embree: only what is needed is filled in and read.
class EmbreeScene {
 public:
  enum class Quality { kLow, kMedium, kHigh };

  /// Builds. The scene has to outlive it and stay where it is: its buffers are shared.
  EmbreeScene(const EmbreeDevice& device, const BenchScene& scene, Quality quality,
              bool is_robust = false);
  ~EmbreeScene();
  EmbreeScene(const EmbreeScene&) = delete;
  EmbreeScene& operator=(const EmbreeScene&) = delete;

  /// Of the tree alone.
  int64_t MemoryBytes() const { return bytes_; }

  /// Ray by ray. The spans are equally long; hits start fresh, with t = t_max.
  void Intersect(std::span<const Ray> rays, std::span<HitRecord> hits) const;
  void Occluded(std::span<const Ray> rays, std::span<uint8_t> occluded) const;

  /// 16 rays at a time, said to be coherent where Embree can take it.
  void IntersectPackets(std::span<const Ray> rays, std::span<HitRecord> hits) const;
  void OccludedPackets(std::span<const Ray> rays, std::span<uint8_t> occluded) const;

  std::optional<SurfaceHit> FindSurface(const Ray& ray) const;

 private:
  RTCScene NewScene(Quality quality, bool is_robust) const;
  void Attach(const TriangleMesh& mesh, RTCScene scene) const;
  void AttachInstance(const Mat4& world_from_part) const;

  RTCDevice device_;
  RTCScene scene_ = nullptr;
  RTCScene part_ = nullptr;
  int64_t bytes_ = 0;
};

}  // namespace candela
