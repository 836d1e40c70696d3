// What standard C++ can do on any system. A file is still replaced at once by a rename, but it may
// be lost with the power soon after; a terminal is treated like a file.
#include "base/platform.h"

#include <chrono>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <new>
#include <random>

namespace candela::platform {
namespace fs = std::filesystem;
namespace {

constexpr std::align_val_t kPage{4096};

/// Writes and closes. Expects that `errno` was 0 before the stream was opened.
std::error_code Finish(std::ofstream* stream, std::span<const std::byte> bytes) {
  stream->write(reinterpret_cast<const char*>(bytes.data()),
                static_cast<std::streamsize>(bytes.size()));
  stream->close();
  return *stream ? std::error_code() : LastError();
}

}  // namespace

// Processes have no number in standard C++; one that no other process is likely to draw will do.
int64_t ProcessNumber() {
  static const int64_t kNumber = std::random_device()();
  return kNumber;
}

// Nobody can be asked whether the process lives, but the bytes of an output are at hand when its
// writing begins: no file takes an hour.
bool IsAbandoned(const fs::path& temporary, int64_t) {
  std::error_code error;
  const fs::file_time_type written = fs::last_write_time(temporary, error);
  return !error && fs::file_time_type::clock::now() - written > std::chrono::hours(1);
}

// Opened to append, a file stays as it is. A pipe would wait for its reader, so that only writing
// can tell.
std::error_code CheckAccess(const fs::path& path) {
  std::error_code error;
  if (!fs::is_regular_file(path, error)) return error;
  errno = 0;
  const std::ofstream stream(path, std::ios::binary | std::ios::app);
  return stream ? std::error_code() : LastError();
}

std::error_code WriteDevice(const fs::path& path, std::span<const std::byte> bytes) {
  errno = 0;
  std::ofstream stream(path, std::ios::binary);
  return Finish(&stream, bytes);
}

std::error_code WriteFile(const fs::path& path, fs::perms mode, std::span<const std::byte> bytes) {
  errno = 0;
  std::ofstream stream(path, std::ios::binary);
  if (stream && mode != fs::perms::unknown) {
    std::error_code error;
    fs::permissions(path, mode, error);
    if (error) return error;
  }
  return Finish(&stream, bytes);
}

// The names reach the disk when the system sees fit.
void SyncFolder(const fs::path&) {}

// Not promised to be safe in a handler, but everywhere no more than calls of the system.
void RemoveFile(const char* path) noexcept {
  std::remove(path);
}

uint64_t PeakMemory() {
  return 0;
}

void* AllocatePages(size_t bytes) {
  void* data = ::operator new(bytes, kPage, std::nothrow);
  return data ? std::memset(data, 0, bytes) : nullptr;
}

void FreePages(void* data, size_t) {
  ::operator delete(data, kPage);
}

bool IsErrorTerminal() {
  return false;
}

int ErrorTerminalColumns() {
  return 0;
}

// Without a terminal no line is ever left open.
void EndErrorTerminalLine() noexcept {}

}  // namespace candela::platform
