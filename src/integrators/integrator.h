#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "math/spectrum.h"
#include "math/vec.h"

namespace candela {

/// One sample of one pixel, to be traced. Any list of them is legal: a tile, a crop, a
/// continuation.
struct SampleRequest {
  uint32_t x = 0, y = 0;  ///< The pixel in the whole picture, from the top left.
  uint32_t index = 0;     ///< The number of the sample in the pixel.
  Vec2 image_point;       ///< Where it goes through the camera's image plane.
};

/// Rays traced so far, by kind.
struct RayCounts {
  uint64_t camera = 0;
  uint64_t reflection = 0;  ///< Mirror reflections and bounces of paths.
  uint64_t shadow = 0;

  uint64_t Total() const { return camera + reflection + shadow; }
  RayCounts& operator+=(const RayCounts& other) {
    camera += other.camera;
    reflection += other.reflection;
    shadow += other.shadow;
    return *this;
  }
};

/// Light that a light path brings to the camera. The mean of the radiance over many light paths is
/// a density over the image plane.
struct Splat {
  Vec2 image_point;
  Spectrum radiance;  ///< Per unit of area of the image plane.
};

/// What a thread needs for itself while it traces.
struct Workspace {
  virtual ~Workspace() = default;
  RayCounts rays;
};

/// A way to compute the light that reaches the camera. Holds its scene by reference. Immutable once
/// made; `Trace` is called concurrently with a workspace for each thread.
class Integrator {
 public:
  virtual ~Integrator() = default;

  virtual std::unique_ptr<Workspace> MakeWorkspace() const { return std::make_unique<Workspace>(); }

  /// Stores the radiance of `samples[i]` in `radiance[i]`. The workspace comes from `MakeWorkspace`
  /// of this integrator. A result depends on its sample alone, never on the others of the list or
  /// on their order; many are quicker together, neighbours one after the other.
  virtual void Trace(std::span<const SampleRequest> samples, Workspace* workspace,
                     std::span<Spectrum> radiance) const = 0;

  /// Whether some of the light is not in what `Trace` gives, but comes to the camera by light
  /// paths.
  virtual bool TracesLightPaths() const { return false; }

  /// Follows `count` light paths from lights to the camera, which are numbered from `first` on, and
  /// appends what they bring. A path depends on its number alone. Any number of them has the same
  /// mean: what `Trace` leaves out, anywhere in the image plane.
  virtual void TraceLightPaths(uint64_t /*first*/, uint64_t /*count*/, Workspace*,
                               std::vector<Splat>* /*splats*/) const {}

  /// The rays of one sample and what came of them, in words, one line each; empty for an integrator
  /// that cannot tell.
  virtual std::vector<std::string> Explain(const SampleRequest&) const { return {}; }
};

}  // namespace candela
