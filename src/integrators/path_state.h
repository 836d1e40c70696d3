#pragma once

#include <cstdint>

#include "integrators/bounces.h"
#include "integrators/medium_stack.h"
#include "integrators/path_colour.h"
#include "integrators/ray_cone.h"
#include "lights/receiver.h"
#include "math/spectrum.h"

namespace candela {

/// What the dimensions of a bounce are used for.
enum BounceUse : uint32_t {
  kDirection = 0,
  kRoulette = 2,
  // Of paths from the camera.
  kLightChoice = 3,
  kLightPoint = 4,
  // Of paths from lights.
  kLens = 4,
};

/// A sample on its way.
struct PathState {
  uint32_t sample = 0;  ///< Its place in the list.
  Spectrum throughput = Spectrum(1);
  MediumStack media;  ///< What it is in.
  PathColour colour;
  /// What brings `throughput`, which is about radiance, to a share of power: the square of the
  /// refractive index.
  float eta_squared = 1;
  BounceCounts bounces;
  bool has_met_surface = false;  ///< One that does not lie hidden in a body.
  /// The density with which the last surface has drawn the ray, over solid angle; 0 when a sampled
  /// light could not have done it: from the camera and from mirrors. Holes on the way change
  /// nothing: rays to sampled lights pass them, too.
  float pdf = 0;
  Receiver receiver;  ///< The point of that surface.
  RayCone cone;
};

}  // namespace candela
