#pragma once

#include <cstdint>

#include "image/raster.h"

namespace candela {

/// Light that a lens scatters into the surroundings of where it belongs.
struct Bloom {
  float strength = 0;  ///< The part of all light, from 0 to 1.
  float radius = 0;    ///< How far it gets, in pixels; not negative.
};

/// Spreads a part of the light of each pixel by a kernel that sums to 1: the mean of three normal
/// distributions, whose standard deviations are a third, a ninth and a twenty-seventh of the
/// radius, each cut off at three of them. The narrow ones are the glow around a light, the wide one
/// is the veil: a sum of Gaussians of growing width, after M. Kawase, "Frame Buffer Postprocessing
/// Effects in DOUBLE-S.T.E.A.L", 2003. Beyond the picture there is no light, so what is spread
/// over its edge is lost, and all other light is kept. A strength of 0 changes nothing. Works on
/// all threads; the result does not depend on them.
void AddBloom(const Bloom& bloom, Image* picture);

/// The memory in bytes that this takes for each sample of the picture, beside the picture itself.
inline constexpr uint64_t kBloomBytesPerSample = 2 * sizeof(float);

}  // namespace candela
