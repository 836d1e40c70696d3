#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "bench_scene.h"

namespace candela {

/// A scene that is made by a formula, the same on every machine.
struct SceneEntry {
  std::string_view name;
  double triangles;  ///< About; times the scale that is asked for.
  bool in_summary;   ///< Counts for the means.
  BenchScene (*make)(double triangles);
};

/// terrain, hairball, room, uneven, terrain8, forest.
const std::vector<SceneEntry>& SceneEntries();

/// An entry's scene. `scale` multiplies the number of triangles.
BenchScene MakeScene(const SceneEntry& entry, double scale);

/// A mesh of an OBJ file, seen from a side of it.
Result<BenchScene> ReadScene(const std::filesystem::path& path);

}  // namespace candela
