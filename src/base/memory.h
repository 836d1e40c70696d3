#pragma once

#include <cstdint>
#include <filesystem>

namespace candela {

/// Bytes that this process may still allocate: the smaller of the memory the system has available
/// and what the control group leaves; the largest number where the system does not tell.
uint64_t AvailableMemory();

/// The two parts of `AvailableMemory`. The second reads the list of groups that this process is in
/// (/proc/self/cgroup) and their folders below `mount` (/sys/fs/cgroup); pages of cached files do
/// not count as used, since the system takes them back when it needs to.
uint64_t SystemMemoryAvailable();
uint64_t ControlGroupMemoryLeft(const std::filesystem::path& list,
                                const std::filesystem::path& mount);

/// The largest resident size that this process has had, in bytes; 0 where the system does not tell.
uint64_t PeakMemory();

}  // namespace candela
