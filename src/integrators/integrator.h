#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "math/spectrum.h"
#include "math/vec.h"
#include "sampling/sample_layers.h"

namespace candela {

/// One sample of one pixel, to be traced. Any list of them is legal: a tile, a crop, a
/// continuation.
struct SampleRequest {
  /// The pixel in the whole picture, from the top left; the highest bit of y may be set to ask for
  /// random numbers of their own.
  uint32_t x = 0, y = 0;
  uint32_t index = 0;  ///< The number of the sample in the pixel.
  Vec2 image_point{};  ///< Where it goes through the camera's image plane,
  float spacing = 0;   ///< and how far from each other pixels are there; 0 when unknown.
};

/// Rays traced so far, by kind.
struct RayCounts {
  uint64_t camera = 0;
  uint64_t reflection = 0;  ///< Mirror reflections and bounces of paths.
  uint64_t shadow = 0;
  /// Surfaces that light has met inside of so many bodies that one more is left out; see
  /// `MediumStack`.
  uint64_t crowded = 0;

  uint64_t Total() const { return camera + reflection + shadow; }
  RayCounts& operator+=(const RayCounts& other) {
    camera += other.camera;
    reflection += other.reflection;
    shadow += other.shadow;
    crowded += other.crowded;
    return *this;
  }
};

/// Where `Integrator::Trace` stores what it finds: entry i of a list belongs to sample i.
struct SampleOutput {
  std::span<Spectrum> radiance;
  std::span<SampleLayers> layers = {};  ///< Empty when nobody asks for them.
  bool needs_uv = false;                ///< Texture coordinates count, even without a texture.
  /// By sample, whether `SampleLayers::surface` is asked for; empty where it is of all. The others
  /// are left as they are.
  std::span<const uint8_t> wants_surface = {};
  /// The light of each group of lights of the scene, sample after sample: all of it is the
  /// radiance, but for rounding. Empty when nobody asks for it.
  std::span<Rgb> group_light = {};
  size_t group_count = 0;  ///< Of each sample.

  bool HasLayers() const { return !layers.empty(); }
  bool WantsSurface(size_t sample) const {
    return wants_surface.empty() || wants_surface[sample] != 0;
  }

  /// What belongs to `count` samples from the sample `begin` on.
  SampleOutput Part(size_t begin, size_t count) const {
    return {radiance.subspan(begin, count),
            HasLayers() ? layers.subspan(begin, count) : std::span<SampleLayers>(),
            needs_uv,
            wants_surface.empty() ? wants_surface : wants_surface.subspan(begin, count),
            group_light.subspan(group_count * begin, group_count * count),
            group_count};
  }

  /// Begins with layers of a sample that has seen nothing yet, if there are any.
  void ClearLayers(size_t sample) const {
    if (!HasLayers()) return;
    static_cast<SampleColours&>(layers[sample]) = {};
    if (WantsSurface(sample)) layers[sample].surface = {};
  }

  /// Begins with a sample that has seen nothing yet.
  void Clear(size_t sample) const {
    radiance[sample] = Spectrum();
    ClearLayers(sample);
    for (Rgb& light : group_light.subspan(group_count * sample, group_count)) light = Rgb();
  }

  /// Adds light that surfaces have scattered so often.
  void Add(size_t sample, uint32_t times_scattered, const Spectrum& light) const {
    radiance[sample] += light;
    if (HasLayers()) layers[sample].AddLight(times_scattered, light.ToRgb());
  }

  /// Says in addition which group of lights it comes from.
  void AddToGroup(size_t sample, uint32_t group, const Spectrum& light) const {
    if (group_count > 0) group_light[group_count * sample + group] += light.ToRgb();
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

  /// Stores the radiance of `samples[i]` in `output.radiance[i]`, and what else is asked for. The
  /// workspace comes from `MakeWorkspace` of this integrator. A result depends on its sample alone,
  /// never on the others of the list or on their order; many are quicker together, neighbours one
  /// after the other.
  virtual void Trace(std::span<const SampleRequest> samples, Workspace* workspace,
                     const SampleOutput& output) const = 0;

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
