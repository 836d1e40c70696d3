#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <string_view>
#include <vector>

#include "geometry/hit_record.h"
#include "geometry/ray.h"

namespace candela {

/// The ways to answer a set of rays that are compared.
enum Mode {
  kEmbreeMedium,
  kEmbreeHigh,
  kEmbreeRobust,  ///< Of medium quality; the answers that count.
  kEmbreePacket,  ///< 16 coherent rays, in the tree of medium quality.
  kOurSingle,     ///< Ours, here and below, in the best tree.
  kOurBatch,      ///< RayOrder::kScattered
  kOurPacket,     ///< RayOrder::kCoherent
  kOurFast,       ///< Single rays in the fast tree.
  kModes
};
inline constexpr std::array<std::string_view, kModes> kModeNames = {
    "embree_medium", "embree_high", "embree_robust", "embree_packet16",
    "our_single",    "our_batch",   "our_packet",    "our_fast_single"};

/// What a mode does with a list of rays; the lists are equally long.
struct Tracer {
  /// Hits start fresh, with t = t_max.
  std::function<void(std::span<const Ray>, std::span<HitRecord>)> intersect;
  std::function<void(std::span<const Ray>, std::span<uint8_t>)> occluded;
};
using Tracers = std::array<Tracer, kModes>;

/// Best CPU time of each mode for all rays, in seconds. In each repetition every mode has its turn.
/// `any_hit`: asks whether the rays hit anything.
std::array<double, kModes> TimeModes(const Tracers& tracers, std::span<const Ray> rays,
                                     bool any_hit, int repetitions);

/// How often answers differ.
struct Differences {
  uint64_t hit_or_miss = 0;
  uint64_t t = 0;  ///< Where both hit: by more than 1e-4 of it, and rounding in instances.
};

/// The answers to a set of rays compared: of each mode with those of Embree's robust mode.
struct Agreement {
  std::array<Differences, kModes> from_robust = {};
  /// Rays that our lists give other bits for than our single rays do, in the same tree.
  uint64_t batch_from_single = 0, packet_from_single = 0;
};
Agreement CompareModes(const Tracers& tracers, std::span<const Ray> rays, bool any_hit);

}  // namespace candela
