#pragma once

#include <filesystem>

#include "base/result.h"

namespace candela {

/// Puts the scenes of the benchmark, and the meshes and the sky that they need, into a folder.
Result<void> WriteSceneFiles(const std::filesystem::path& scenes,
                             const std::filesystem::path& folder);

}  // namespace candela
