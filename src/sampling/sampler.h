#pragma once

#include <cstdint>

#include "math/vec.h"

namespace candela {

enum class SamplerKind {
  kSobol,        ///< Owen-scrambled Sobol points: every pair of dimensions is evenly filled.
  kIndependent,  ///< Hashes, for comparison: the error falls as slowly as that of dice.
};

/// Which dimensions belong to what, so that a new use of random numbers in one place does not
/// change the numbers of another. Dimensions 0-15 belong to the camera, 16 to each bounce.
inline constexpr uint32_t kFilmDimension = 0;  ///< a pair: the position within the pixel filter
inline constexpr uint32_t kLensDimension = 2;  ///< a pair: the position on the camera's lens
inline constexpr uint32_t kCameraDimensions = 16;
inline constexpr uint32_t kBounceDimensions = 16;

/// The first of the 16 dimensions of a bounce; 0 is the surface that the camera sees.
constexpr uint32_t BounceDimension(uint32_t bounce) {
  return kCameraDimensions + kBounceDimensions * bounce;
}

/// The random numbers of one sample of one pixel: a pure function of (seed, pixel, sample,
/// dimension).
///
/// Each dimension and each pair of neighbouring dimensions is a scrambled (0,2)-sequence over the
/// sample index: any aligned run of 2^k samples puts one point into each box of area 2^-k of every
/// shape. The sequences of different pixels and dimensions are shuffled and scrambled independently
/// ("padding"), after B. Burley, "Practical hash-based Owen scrambling" (JCGT 2020). Any number of
/// samples is a good number, powers of two are best, and more may be added at any time.
///
/// Numbers are multiples of 2^-24 in [0, 1), never 1. All functions may be called concurrently.
class Sampler {
 public:
  Sampler(uint32_t seed, uint32_t pixel_x, uint32_t pixel_y, uint32_t sample_index,
          SamplerKind kind = SamplerKind::kSobol);

  float Get1D(uint32_t dimension) const;

  /// A pair that is evenly spread as a pair. It takes the place of `dimension` and `dimension + 1`.
  Vec2 Get2D(uint32_t dimension) const;

 private:
  uint64_t pixel_hash_;
  uint32_t sample_index_;
  SamplerKind kind_;
};

}  // namespace candela
