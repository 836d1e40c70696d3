// The calls of Linux, macOS and their relatives.
#include "base/platform.h"

#include <fcntl.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>

namespace candela::platform {
namespace fs = std::filesystem;
namespace {

/// An open file descriptor that closes itself and that children do not inherit.
class Descriptor {
 public:
  Descriptor(const fs::path& path, int flags)
      : value_(::open(path.c_str(), flags | O_CLOEXEC, 0666)) {}
  ~Descriptor() { Close(); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  bool IsOpen() const { return value_ >= 0; }
  bool SetMode(fs::perms mode) const { return ::fchmod(value_, static_cast<mode_t>(mode)) == 0; }
  bool Write(std::span<const std::byte> bytes) const {
    while (!bytes.empty()) {
      const ssize_t written = ::write(value_, bytes.data(), bytes.size());
      if (written < 0 && errno == EINTR) continue;
      if (written <= 0) return false;
      bytes = bytes.subspan(static_cast<size_t>(written));
    }
    return true;
  }
  /// Some file systems cannot sync; that is no reason to refuse the output.
  bool Sync() const {
    return ::fsync(value_) == 0 || errno == EINVAL || errno == ENOTSUP || errno == EROFS;
  }
  bool Close() {
    const int old = value_;
    value_ = -1;
    return old < 0 || ::close(old) == 0;
  }

 private:
  int value_;
};

}  // namespace

int64_t ProcessNumber() {
  return ::getpid();
}

bool IsAbandoned(const fs::path&, int64_t process) {
  return ::kill(static_cast<pid_t>(process), 0) != 0 && errno == ESRCH;
}

std::error_code CheckAccess(const fs::path& path) {
  return ::access(path.c_str(), W_OK) == 0 ? std::error_code() : LastError();
}

std::error_code WriteDevice(const fs::path& path, std::span<const std::byte> bytes) {
  Descriptor device(path, O_WRONLY);
  const bool is_written = device.IsOpen() && device.Write(bytes) && device.Close();
  return is_written ? std::error_code() : LastError();
}

std::error_code WriteFile(const fs::path& path, fs::perms mode, std::span<const std::byte> bytes) {
  Descriptor file(path, O_WRONLY | O_CREAT | O_TRUNC);
  const bool is_written = file.IsOpen() && (mode == fs::perms::unknown || file.SetMode(mode)) &&
                          file.Write(bytes) && file.Sync() && file.Close();
  return is_written ? std::error_code() : LastError();
}

void SyncFolder(const fs::path& folder) {
  const Descriptor descriptor(folder, O_RDONLY | O_DIRECTORY);
  if (descriptor.IsOpen()) descriptor.Sync();
}

void RemoveFile(const char* path) noexcept {
  ::unlink(path);
}

uint64_t PeakMemory() {
  rusage usage{};
  if (::getrusage(RUSAGE_SELF, &usage) != 0) return 0;
#ifdef __APPLE__
  constexpr uint64_t kUnit = 1;
#else
  constexpr uint64_t kUnit = 1024;
#endif
  return static_cast<uint64_t>(usage.ru_maxrss) * kUnit;
}

void* AllocatePages(size_t bytes) {
  void* data = ::mmap(nullptr, bytes, PROT_READ | PROT_WRITE,
                      MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (data == MAP_FAILED) return nullptr;
#ifdef MADV_HUGEPAGE
  // Only advice: where it is not taken, things are slower.
  static_cast<void>(::madvise(data, bytes, MADV_HUGEPAGE));
#endif
  return data;
}

void FreePages(void* data, size_t bytes) {
  ::munmap(data, bytes);
}

bool IsErrorTerminal() {
  return ::isatty(STDERR_FILENO) != 0;
}

int ErrorTerminalColumns() {
  winsize size{};
  return ::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 ? size.ws_col : 0;
}

void EndErrorTerminalLine() noexcept {
  // When even this fails there is nobody left to tell.
  [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, "\n", 1);
}

}  // namespace candela::platform
