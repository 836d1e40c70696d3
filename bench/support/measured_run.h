#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "base/result.h"

namespace candela {

/// What one process took, from before its start until it was gone.
struct MeasuredRun {
  double wall_seconds = 0;
  double cpu_seconds = 0;   ///< Of all its threads, in the program and in the system.
  uint64_t peak_bytes = 0;  ///< The most memory that was resident at once.
};

/// Runs a program to its end, without its standard output. An error when it cannot be started or
/// its exit status is not 0.
Result<MeasuredRun> Measure(const std::filesystem::path& program,
                            const std::vector<std::string>& arguments);

}  // namespace candela
