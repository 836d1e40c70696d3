#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <string>
#include <system_error>
#include <utility>

#include "base/files.h"

namespace candela {
namespace fs = std::filesystem;
namespace {

constexpr char kMark[] = ".candela-";  // ".NAME.candela-PID.tmp" beside the output NAME
constexpr char kEnd[] = ".tmp";

// The temporary file being written, for `RemoveUnfinishedOutput`. One write at a time per process.
char unfinished_path[4096];
std::atomic<bool> is_unfinished = false;

Error OutputError(const char* what) {
  return Error{ErrorCode::kOutput, std::string(what) + ": " + std::strerror(errno)};
}

/// An open file descriptor that closes itself.
class Descriptor {
 public:
  explicit Descriptor(int value) : value_(value) {}
  ~Descriptor() { Close(); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  int get() const { return value_; }
  bool ok() const { return value_ >= 0; }
  bool Close() {
    const int old = value_;
    value_ = -1;
    return old < 0 || ::close(old) == 0;
  }

 private:
  int value_;
};

/// The path behind symbolic links, whose last part need not exist. Links that lead in a circle
/// stay.
fs::path ResolveLinks(fs::path path) {
  std::error_code error;
  for (int depth = 0; depth < 40 && fs::is_symlink(fs::symlink_status(path, error)); ++depth) {
    const fs::path target = fs::read_symlink(path, error);
    if (error) break;
    path = target.is_absolute() ? target : path.parent_path() / target;
  }
  return path;
}

fs::path FolderOf(const fs::path& path) {
  return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

/// Devices and pipes cannot be replaced by renaming; they are written as they are. Asked of the
/// path as given: /dev/stdout leads to a pipe by links whose text is not a path.
bool IsWrittenDirectly(const fs::path& path) {
  std::error_code error;
  const fs::file_type type = fs::status(path, error).type();
  return type == fs::file_type::character || type == fs::file_type::block ||
         type == fs::file_type::fifo;
}

fs::path TemporaryFor(const fs::path& path) {
  // Long names are cut, so that the temporary one does not exceed what the file system takes.
  const std::string name = path.filename().string().substr(0, 200);
  return FolderOf(path) / ("." + name + kMark + std::to_string(::getpid()) + kEnd);
}

/// Removes temporary files of this output whose process is gone.
void RemoveLeftovers(const fs::path& path) {
  const std::string start = "." + path.filename().string().substr(0, 200) + kMark;
  std::error_code error;
  for (auto entry = fs::directory_iterator(FolderOf(path), error);
       !error && entry != fs::directory_iterator(); entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    if (!name.starts_with(start) || !name.ends_with(kEnd)) continue;
    const std::string digits =
        name.substr(start.size(), name.size() - start.size() - sizeof kEnd + 1);
    if (digits.empty() || digits.find_first_not_of("0123456789") != std::string::npos) continue;
    const long pid = std::strtol(digits.c_str(), nullptr, 10);
    const bool is_gone = ::kill(static_cast<pid_t>(pid), 0) != 0 && errno == ESRCH;
    std::error_code ignored;
    if (is_gone || pid == ::getpid()) fs::remove(entry->path(), ignored);
  }
}

bool WriteAll(int descriptor, std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    bytes = bytes.subspan(static_cast<size_t>(written));
  }
  return true;
}

Result<void> WriteDirectly(const fs::path& path, std::span<const std::byte> bytes) {
  Descriptor file(::open(path.c_str(), O_WRONLY | O_CLOEXEC));
  if (!file.ok()) return OutputError("cannot be opened for writing");
  if (!WriteAll(file.get(), bytes) || !file.Close()) return OutputError("cannot be written");
  return {};
}

/// Some file systems cannot sync; that is no reason to refuse the output.
bool Sync(int descriptor) {
  return ::fsync(descriptor) == 0 || errno == EINVAL || errno == ENOTSUP || errno == EROFS;
}

Result<void> WriteTemporary(const fs::path& temporary, const fs::path& target,
                            std::span<const std::byte> bytes) {
  Descriptor file(::open(temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666));
  if (!file.ok()) return OutputError("cannot be written");
  struct stat old {};
  if (::stat(target.c_str(), &old) == 0 && ::fchmod(file.get(), old.st_mode & 07777) != 0) {
    return OutputError("cannot keep the mode of the old file");
  }
  if (!WriteAll(file.get(), bytes)) return OutputError("cannot be written");
  if (!Sync(file.get()) || !file.Close()) return OutputError("cannot be stored safely");
  if (::rename(temporary.c_str(), target.c_str()) != 0) return OutputError("cannot be replaced");
  return {};
}

/// What can be said against a new file at `target` without making one.
Result<void> CheckPlace(const fs::path& target) {
  const auto refuse = [](std::string why) { return Error{ErrorCode::kOutput, std::move(why)}; };
  if (!target.has_filename()) return refuse("is not the name of a file");
  std::error_code error;
  if (fs::is_symlink(target, error)) return refuse("is a symbolic link that leads nowhere");
  const fs::file_status status = fs::status(target, error);
  if (!fs::status_known(status)) return refuse("cannot be written: " + error.message());
  if (fs::is_directory(status)) return refuse("is a folder");
  if (fs::is_socket(status)) return refuse("is a socket");
  if (!fs::is_directory(FolderOf(target), error)) return refuse("its folder does not exist");
  // A rename asks only the folder, yet a file that is protected is meant to stay.
  if (fs::exists(status) && ::access(target.c_str(), W_OK) != 0) {
    return OutputError("cannot be written");
  }
  return {};
}

}  // namespace

void RemoveUnfinishedOutput() noexcept {
  if (is_unfinished.load()) ::unlink(unfinished_path);
}

Result<void> CheckWritable(const fs::path& path) {
  if (IsWrittenDirectly(path)) {
    if (::access(path.c_str(), W_OK) != 0) return OutputError("cannot be written");
    return {};
  }
  const fs::path target = ResolveLinks(path);
  if (Result<void> place = CheckPlace(target); !place) return place;
  const fs::path temporary = TemporaryFor(target);
  const Descriptor probe(::open(temporary.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0666));
  if (!probe.ok()) return OutputError("cannot be written");
  ::unlink(temporary.c_str());
  return {};
}

Result<void> WriteFileAtomically(const fs::path& path, std::span<const std::byte> bytes) {
  if (IsWrittenDirectly(path)) return WriteDirectly(path, bytes);
  const fs::path target = ResolveLinks(path);
  if (Result<void> place = CheckPlace(target); !place) return place;

  RemoveLeftovers(target);
  const fs::path temporary = TemporaryFor(target);
  if (temporary.native().size() < sizeof unfinished_path) {
    std::memcpy(unfinished_path, temporary.c_str(), temporary.native().size() + 1);
    is_unfinished = true;
  }
  Result<void> written = WriteTemporary(temporary, target, bytes);
  if (!written) ::unlink(temporary.c_str());
  is_unfinished = false;
  if (!written) return written;

  // The rename is done; a folder that cannot be opened or synced does not undo it.
  const Descriptor folder(::open(FolderOf(target).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (folder.ok()) Sync(folder.get());
  return {};
}

bool IsSameFile(const fs::path& a, const fs::path& b) {
  std::error_code error;
  if (fs::equivalent(a, b, error)) return true;
  // Made absolute first: a relative path stays relative where nothing of it exists yet.
  const fs::path one = fs::weakly_canonical(fs::absolute(ResolveLinks(a), error), error);
  const fs::path two = fs::weakly_canonical(fs::absolute(ResolveLinks(b), error), error);
  return !error && one == two;
}

fs::path ExecutableFolder() {
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  return error ? fs::path() : program.parent_path();
}

}  // namespace candela
