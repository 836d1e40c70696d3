#pragma once

#include <cstdint>

#include "integrators/integrator.h"
#include "sampling/sampler.h"
#include "scene/scene.h"

namespace candela {

/// When the samples of a picture see the scene: evenly spread over the time in which the shutter is
/// open, those of each pixel on their own. Cook, Porter and Carpenter, "Distributed Ray Tracing",
/// 1984.
class ShutterTimes {
 public:
  ShutterTimes(const Scene& scene, uint32_t seed, SamplerType sampler)
      : shutter_(scene.camera().shutter()),
        is_moving_(scene.IsMoving()),
        seed_(seed),
        sampler_(sampler) {}

  /// If not, nothing asks for the time, and that of all rays is 0.
  bool AreNeeded() const { return is_moving_; }

  float Draw(const Sampler& sampler) const {
    // A shutter that is open for a moment only needs no number.
    if (shutter_.open == shutter_.close) return shutter_.open;
    return shutter_.TimeOf(sampler.Get1D(kTimeDimension));
  }
  float Draw(const SampleRequest& sample) const {
    return Draw(Sampler(seed_, sample.x, sample.y, sample.index, sampler_));
  }

 private:
  Shutter shutter_;
  bool is_moving_;
  uint32_t seed_;
  SamplerType sampler_;
};

/// The ray of a sample at a time; see `Camera::GenerateRayAt`.
inline Ray CameraRayAt(const Scene& scene, float time, Vec2 image_point,
                       std::optional<Vec2> u = std::nullopt) {
  Ray ray = scene.camera().GenerateRayAt(time, image_point, u);
  ray.time = time;
  return ray;
}

}  // namespace candela
