#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "base/result.h"

namespace candela {

/// The bytes of a regular file. A missing or unreadable file, a folder, a device, a FIFO or a
/// socket is an error that says which; the message does not repeat the path.
Result<std::string> ReadFile(const std::filesystem::path& path);

/// Checks that `WriteFileAtomically(path, ...)` can be expected to succeed: the folder exists and a
/// file can be made in it, or the path is a device or pipe that can be opened. Leaves nothing
/// behind.
Result<void> CheckWritable(const std::filesystem::path& path);

/// Puts `bytes` into the file `path` so that at any moment, a kill or a full disk included, the
/// path holds either the old content or the new: written under a temporary name in the same folder,
/// synced, renamed, folder synced. Symbolic links are followed; the mode of an old file is kept;
/// devices and pipes are written directly. Removes what a killed earlier run left for this path.
Result<void> WriteFileAtomically(const std::filesystem::path& path,
                                 std::span<const std::byte> bytes);

/// True when both paths name the same existing file, or the same place for a new one.
bool IsSameFile(const std::filesystem::path& a, const std::filesystem::path& b);

/// The folder of the running program, empty where the system cannot tell.
std::filesystem::path ExecutableFolder();

/// Removes the temporary file of a write that is under way, if any. Async-signal-safe: meant for
/// handlers that end the process (see `ExitOnStopSignals`).
void RemoveUnfinishedOutput() noexcept;

}  // namespace candela
