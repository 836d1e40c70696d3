#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "modes.h"
#include "rays.h"

namespace candela {

/// One set of rays in one scene.
struct SetResult {
  RaySet set = RaySet::kPrimary;
  size_t rays = 0;
  std::array<double, kModes> seconds = {};  ///< For all rays.
  Agreement agreement;

  double MegaraysPerSecond(Mode mode) const {
    return static_cast<double>(rays) / seconds[mode] * 1e-6;
  }
  /// How many times as fast as another mode.
  double Ratio(Mode mode, Mode other) const { return seconds[other] / seconds[mode]; }
};

/// The four ways to build a tree that are compared.
enum BuildMode { kBuildMedium, kBuildHigh, kBuildFast, kBuildBest, kBuildModes };
inline constexpr std::array<std::string_view, kBuildModes> kBuildNames = {
    "embree_medium", "embree_high", "our_fast", "our_best"};

/// All that was measured of one scene.
struct SceneResult {
  std::string name;
  bool in_summary = true;
  bool is_closed = false;
  uint64_t triangles = 0;                      ///< Each instance counted.
  uint64_t built_triangles = 0;                ///< Each instance left out.
  std::array<double, kBuildModes> bytes = {};  ///< Of the trees.
  /// Of the process when our best tree, and nothing else, was built; of the first scene only.
  std::optional<double> peak_bytes;
  std::optional<std::array<double, kBuildModes>> build_seconds;
  std::vector<SetResult> sets;

  double BytesPerTriangle(BuildMode mode) const {
    return bytes[mode] / static_cast<double>(built_triangles);
  }
};

struct BenchResult {
  std::string isa;         ///< Ours.
  std::string embree_isa;  ///< What Embree is restricted to; empty for nothing.
  int repetitions = 0;
  int build_threads = 0;
  std::vector<SceneResult> scenes;
};

}  // namespace candela
