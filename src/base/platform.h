#pragma once

#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <system_error>

/// What standard C++ has no call for, or none that promises enough. `posix/platform.cpp` asks the
/// system; `portable/platform.cpp` makes do with standard C++ and says what is lost. CMake compiles
/// one of them (CANDELA_PLATFORM); a port to another system is one more such file. For base/ only.
namespace candela::platform {

/// Why the last call of the C library or of a stream failed. Streams may fail without a reason.
inline std::error_code LastError() {
  return {errno == 0 ? EIO : errno, std::generic_category()};
}

/// The number of this process that the names of its temporary files carry.
int64_t ProcessNumber();

/// True when the process with this number, which made the file `temporary`, writes it no more.
bool IsAbandoned(const std::filesystem::path& temporary, int64_t process);

/// Whether this process may write the file, device or pipe `path`, which exists.
std::error_code CheckAccess(const std::filesystem::path& path);

/// Writes `bytes` to the device or pipe `path`.
std::error_code WriteDevice(const std::filesystem::path& path, std::span<const std::byte> bytes);

/// Writes `bytes` to the file `path`, made new or emptied, and waits until the disk has them. The
/// file gets its mode while it is empty; `perms::unknown` is what the system gives to new files.
std::error_code WriteFile(const std::filesystem::path& path, std::filesystem::perms mode,
                          std::span<const std::byte> bytes);

/// Waits until the disk has the names in `folder`, where the system and the file system can.
void SyncFolder(const std::filesystem::path& folder);

/// Removes a file if it is there. Async-signal-safe.
void RemoveFile(const char* path) noexcept;

/// The largest resident size that this process has had, in bytes; 0 where the system does not tell.
uint64_t PeakMemory();

/// Zeroed memory for a large block, on large pages where the system has them; null when there is no
/// room. Pages are taken when they are first written to, as far as the system can.
void* AllocatePages(size_t bytes);

void FreePages(void* data, size_t bytes);

/// Whether stderr is a terminal, as far as the system tells.
bool IsErrorTerminal();

/// Characters in a line of that terminal; 0 where the system does not tell.
int ErrorTerminalColumns();

/// Begins a new line of that terminal. Async-signal-safe.
void EndErrorTerminalLine() noexcept;

}  // namespace candela::platform
