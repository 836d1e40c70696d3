#include "rays.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "math/elementary.h"
#include "math/frame.h"
#include "random.h"
#include "sampling/warp.h"

namespace candela {
namespace {

constexpr int kBounces = 4;           ///< Of deep rays.
constexpr int kTries = 16;            ///< Directions that a bounce may try until it hits something.
constexpr uint32_t kRounds = 100;     ///< Over the picture, at most.
constexpr size_t kWavefront = 65536;  ///< Rays that are under way together.

/// Every second bit, moved together.
uint32_t EvenBits(uint32_t x) {
  x &= 0x55555555;
  x = (x | x >> 1) & 0x33333333;
  x = (x | x >> 2) & 0x0f0f0f0f;
  x = (x | x >> 4) & 0x00ff00ff;
  return (x | x >> 8) & 0x0000ffff;
}

class PathFinder {
 public:
  PathFinder(const BenchScene& scene, const EmbreeScene& embree, int side)
      : scene_(scene), embree_(embree), side_(static_cast<float>(side)) {
    frame_.z = Normalize(scene.view.look_at - scene.view.eye);
    frame_.x = Normalize(Cross(frame_.z, Vec3{0, 1, 0}));
    frame_.y = Cross(frame_.x, frame_.z);
    half_ = static_cast<float>(TanDegrees(0.5 * scene.view.fov_degrees));
  }

  /// The ray of a set that belongs to the pixel with this number along Morton's curve, if its path
  /// gets that far.
  std::optional<Ray> Find(RaySet set, uint32_t pixel, Random* random) const {
    const Ray camera = CameraRay(pixel, random);
    if (set == RaySet::kPrimary) return camera;
    std::optional<SurfaceHit> hit = embree_.FindSurface(camera);
    if (!hit) return std::nullopt;
    if (set == RaySet::kShadow) return ShadowRay(*hit, random);
    for (int bounce = 1; set == RaySet::kDeep && bounce < kBounces; ++bounce) {
      std::optional<SurfaceHit> next;
      for (int i = 0; i < kTries && !next; ++i) next = embree_.FindSurface(Bounce(*hit, random));
      if (!next) return std::nullopt;
      hit = next;
    }
    return Bounce(*hit, random);
  }

 private:
  Ray CameraRay(uint32_t pixel, Random* random) const {
    const Vec2 place = random->Pair();
    const float x = (static_cast<float>(EvenBits(pixel)) + place.x) / side_ * 2 - 1;
    const float y = 1 - (static_cast<float>(EvenBits(pixel >> 1)) + place.y) / side_ * 2;
    return {scene_.view.eye, Normalize(frame_.ToWorld({x * half_, y * half_, 1}))};
  }

  Ray Bounce(const SurfaceHit& hit, Random* random) const {
    const Vec3 local = SampleCosineHemisphere(random->Pair());
    return {Beside(hit), Frame::FromNormal(hit.n).ToWorld(local)};
  }

  /// From the surface to t = 1 in the light. Nobody asks for a light behind the surface.
  std::optional<Ray> ShadowRay(const SurfaceHit& hit, Random* random) const {
    const Vec3 origin = Beside(hit);
    const Vec3 target = scene_.light.center + random->Direction() * scene_.light.radius;
    Ray ray(origin, target - origin);
    if (Dot(ray.direction, hit.n) <= 0) return std::nullopt;
    ray.t_max = 1;
    return ray;
  }

  /// A point so far off the surface that a ray from there does not hit it again.
  static Vec3 Beside(const SurfaceHit& hit) {
    const Vec3 size = Abs(hit.p);
    return hit.p + hit.n * (1e-5f * std::max({size.x, size.y, size.z}));
  }

  const BenchScene& scene_;
  const EmbreeScene& embree_;
  Frame frame_;
  float side_, half_ = 1;
};

void ShuffleWavefronts(std::vector<Ray>* rays) {
  Random random(6);
  for (size_t begin = 0; begin < rays->size(); begin += kWavefront) {
    const size_t count = std::min(kWavefront, rays->size() - begin);
    for (size_t i = count; i > 1; --i) {
      const size_t other = random.Below(static_cast<uint32_t>(i));
      std::swap((*rays)[begin + i - 1], (*rays)[begin + other]);
    }
  }
}

constexpr std::string_view kNames[] = {"primary", "diffuse", "deep", "shadow"};

}  // namespace

std::string_view RaySetName(RaySet set) {
  return kNames[static_cast<size_t>(set)];
}

std::optional<RaySet> FindRaySet(std::string_view name) {
  for (const RaySet set : kRaySets) {
    if (RaySetName(set) == name) return set;
  }
  return std::nullopt;
}

Result<std::vector<Ray>> MakeRays(RaySet set, const BenchScene& scene, const EmbreeScene& embree,
                                  int side) {
  const auto count = static_cast<uint32_t>(side) * static_cast<uint32_t>(side);
  const PathFinder finder(scene, embree, side);
  std::vector<Ray> rays;
  rays.reserve(count);
  for (uint32_t round = 0; rays.size() < count; ++round) {
    if (round == kRounds) {
      return Error{ErrorCode::kInput,
                   fmt::format("hardly any path leads to a ray of the set '{}'; choose others "
                               "with --rays",
                               RaySetName(set))};
    }
    for (uint32_t pixel = 0; pixel < count && rays.size() < count; ++pixel) {
      Random random(Hash(round, pixel));
      if (const auto ray = finder.Find(set, pixel, &random)) rays.push_back(*ray);
    }
  }
  if (set == RaySet::kDeep) ShuffleWavefronts(&rays);
  return rays;
}

}  // namespace candela
