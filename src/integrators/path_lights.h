#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "geometry/surface_point.h"
#include "integrators/path_state.h"
#include "integrators/path_techniques.h"
#include "lights/environment_light.h"
#include "lights/light.h"
#include "lights/light_picker.h"
#include "math/vec.h"
#include "scene/scene.h"

namespace candela {

/// The picture of the surroundings as a light, which refers to it. Null where they are the same
/// everywhere: no direction to such a sky is better than another, and the surface's own choice is
/// the best there is.
std::unique_ptr<const EnvironmentLight> EnvironmentOf(const Background& background);

/// The light of a scene as paths get it: a light is chosen and sampled from a surface, or a ray
/// finds it, and where both can happen each is weighed against the other: Veach, "Optimally
/// Combining Sampling Techniques for Monte Carlo Rendering", 1995. Holds its scene by reference.
/// Immutable; called concurrently.
class PathLights {
 public:
  PathLights(const Scene& scene, const PathTechniques& techniques);

  /// False when there is nothing to sample.
  bool CanSample() const { return picker_.HasLights(); }

  /// Light that reaches a point if nothing is in the way.
  struct Draw {
    LightSample sample;
    float choice;       ///< The probability of the light.
    uint32_t group;     ///< Of lights, in which it is.
    bool is_found_too;  ///< Rays can find the light as well: what it gives is to be weighed.

    /// The density of light and direction, over solid angle.
    float Pdf() const { return choice * sample.pdf; }
  };
  /// Whether the choice of a light takes a number.
  bool HasChoice() const { return picker_.NeedsNumber(); }
  /// Nothing was drawn when the density of the sample is 0.
  Draw Sample(const Receiver& to, float u_choice, Vec2 u_point) const;

  /// The part that falls to a technique of density `pdf` when another has `other_pdf`.
  float Weight(float pdf, float other_pdf) const;

  /// What a path finds that leaves the scene, and on the surface of a light, weighed. `visit` gets
  /// the parts of the sky, each with its group of lights.
  template <class Visit>
  Spectrum FromSky(const PathState& path, Vec3 direction, const Visit& visit) const {
    Spectrum sum = FromBackground(path, direction);
    visit(scene_.GroupOfBackground(), sum);
    for (const uint32_t sun : suns_) {
      const Spectrum light = FromSun(path, direction, sun);
      if (light.IsBlack()) continue;
      sum += light;
      visit(scene_.GroupOfLight(sun), light);
    }
    return sum;
  }
  Spectrum FromSurface(const PathState& path, const SurfacePoint& point, Vec3 wo,
                       uint32_t light) const;

 private:
  Spectrum FromBackground(const PathState& path, Vec3 direction) const;
  Spectrum FromSun(const PathState& path, Vec3 direction, uint32_t sun) const;
  float WeightOfFound(const PathState& path, uint32_t light, const SurfacePoint& point,
                      Vec3 w) const;

  const Scene& scene_;
  PathTechniques techniques_;
  std::unique_ptr<const EnvironmentLight> environment_;
  std::vector<const Light*>
      lights_;                  ///< Those of the scene at their indices, then the environment.
  std::vector<uint32_t> suns_;  ///< Those of the scene that rays can find in the sky.
  LightPicker picker_;
};

}  // namespace candela
