#pragma once

#include <array>
#include <cstdint>

#include "math/spectrum.h"
#include "math/vec.h"

namespace candela {

/// What every sample adds to layers.
struct SampleColours {
  Rgb albedo;  ///< The part of white light that the first surface reflects or lets through, about.

  /// The radiance by how often surfaces have scattered it: never (lamps and the sky as the camera
  /// sees them), once, and more often.
  std::array<Rgb, 3> light;

  void AddLight(uint32_t times_scattered, Rgb radiance) {
    light[times_scattered < 2 ? times_scattered : 2] += radiance;
  }
};

/// What is recorded of one sample beside its radiance, for the layers of a picture. Lies here since
/// integrators write it and the film reads it.
struct SampleLayers : SampleColours {
  /// The surface that the camera's ray meets first; where it meets none the numbers are 0.
  struct Surface {
    uint32_t object = 0, material = 0;  ///< One more than their indices in the scene.
    float depth = 0;                    ///< The distance ahead of the camera, along its view.
    Vec3 position;                      ///< In world space.
    Vec3 n_shading, n_geometric;        ///< Unit vectors on the side of the camera.
    Vec2 uv;

    friend bool operator==(const Surface&, const Surface&) = default;
  };
  Surface surface;
};

}  // namespace candela
