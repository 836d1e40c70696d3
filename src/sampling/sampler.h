#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "math/vec.h"
#include "sampling/hash.h"
#include "sampling/scrambled_sobol.h"

namespace candela {

enum class SamplerKind : uint8_t {
  kSobol,        ///< Owen-scrambled Sobol points: every pair of dimensions is evenly filled.
  kStratified,   ///< Blocks of 16 samples, each with one in every one of 4 x 4 squares.
  kIndependent,  ///< Hashes, for comparison: the error falls as slowly as that of dice.
  kBlueNoise,    ///< Sobol points dealt out to neighbouring pixels, whose errors then cancel.
};

/// A kind of sampler and what it has to know.
struct SamplerType {
  SamplerKind kind = SamplerKind::kSobol;
  /// Of `kBlueNoise`: the logarithm of the number of samples that a pixel is to get. More are
  /// possible; every such number of them is a pattern of its own. At most 16.
  uint8_t log2_samples = 0;

  constexpr SamplerType() = default;
  constexpr SamplerType(SamplerKind sampler) : kind(sampler) {}
  /// Made for so many samples of each pixel, or the next power of two.
  SamplerType(SamplerKind sampler, uint32_t samples);

  friend bool operator==(const SamplerType&, const SamplerType&) = default;
};

/// A row of the table of samplers.
struct SamplerEntry {
  std::string_view name;
  std::string_view description;
  SamplerKind kind;
  /// Pixels know nothing of each other: their numbers are related by chance alone.
  bool has_independent_pixels;
};

/// All samplers, in the order of the manual.
std::span<const SamplerEntry> Samplers();

/// The sampler of that name, or null.
const SamplerEntry* FindSampler(std::string_view name);

/// Which dimensions belong to what, so that a new use of random numbers in one place does not
/// change the numbers of another. Dimensions 0-15 belong to the camera, 16 to each bounce.
inline constexpr uint32_t kFilmDimension = 0;  ///< a pair: the position within the pixel filter
inline constexpr uint32_t kLensDimension = 2;  ///< a pair: the position on the camera's lens
inline constexpr uint32_t kWavelengthDimension = 6;  ///< of a path from the camera or from a light
inline constexpr uint32_t kTimeDimension = 8;        ///< of the same, when something moves
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
/// `kBlueNoise` takes one such sequence for all pixels of a square of the picture, along a curve
/// through them that keeps near what is near: A. Ahmed and P. Wonka, "Screen-space blue-noise
/// diffusion of Monte Carlo sampling error via hierarchical ordering of pixels" (2020).
/// `kStratified` are blocks after A. Kensler, "Correlated multi-jittered sampling" (2013).
///
/// Numbers are multiples of 2^-24 in [0, 1), never 1. All functions may be called concurrently.
class Sampler {
 public:
  Sampler() = default;  ///< Of nothing in particular, to be replaced.
  Sampler(uint32_t seed, uint32_t pixel_x, uint32_t pixel_y, uint32_t sample_index,
          SamplerType type = {});

  float Get1D(uint32_t dimension) const {
    const uint64_t hash = MixBits(pixel_hash_, dimension);
    return kind_ == SamplerKind::kSobol ? sobol::Point(sample_index_, hash) : Other1D(hash);
  }

  /// A pair that is evenly spread as a pair. It takes the place of `dimension` and `dimension + 1`.
  Vec2 Get2D(uint32_t dimension) const {
    const uint64_t hash = MixBits(pixel_hash_, dimension);
    return kind_ == SamplerKind::kSobol ? sobol::PairOfPoints(sample_index_, hash) : Other2D(hash);
  }

  /// What each of many samplers gives, which are of one kind; lists of the same size. For Sobol
  /// points several times as fast.
  static void Get1D(std::span<const Sampler> samplers, uint32_t dimension,
                    std::span<float> numbers);
  static void Get2D(std::span<const Sampler> samplers, uint32_t dimension, std::span<Vec2> pairs);

 private:
  /// Calls `take(i, block, k)` for each i, with the points of sampler i in entry k of a block.
  template <class Find, class Take>
  static void FindInBlocks(std::span<const Sampler> samplers, Find find, Take take);

  // Of the kinds without Sobol points.
  float Other1D(uint64_t hash) const;
  Vec2 Other2D(uint64_t hash) const;
  float Stratified1D(uint64_t hash) const;
  Vec2 Stratified2D(uint64_t hash) const;

  uint64_t pixel_hash_ = 0;
  uint32_t sample_index_ = 0;  ///< For Sobol points with its bits reversed, as these want it.
  SamplerKind kind_ =
      SamplerKind::kSobol;  ///< `kSobol` for blue noise as well: its hash and index make it.
};

}  // namespace candela
