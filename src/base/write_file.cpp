#include <atomic>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <string>
#include <system_error>
#include <utility>

#include "base/files.h"
#include "base/number.h"
#include "base/platform.h"

namespace candela {
namespace fs = std::filesystem;
namespace {

constexpr char kMark[] = ".candela-";  // ".NAME.candela-PID.tmp" beside the output NAME
constexpr char kEnd[] = ".tmp";

// The temporary file of this process, for `RemoveUnfinishedOutput`. One at a time.
char unfinished_path[4096];
std::atomic<bool> is_unfinished = false;
static_assert(std::atomic<bool>::is_always_lock_free, "signal handlers use it");

/// Success, or the reason why an output cannot be written.
Result<void> Outcome(std::error_code error) {
  if (!error) return {};
  return Error{ErrorCode::kOutput, "cannot be written: " + error.message()};
}

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

/// How the names of all temporary files for an output begin. Long names are cut, so that these do
/// not exceed what the file system takes.
std::string TemporaryStart(const fs::path& target) {
  return "." + target.filename().string().substr(0, 200) + kMark;
}

/// The file beside `target` that becomes it by a rename. If it does not, because writing failed or
/// a signal ends the process, it is removed.
class TemporaryFile {
 public:
  explicit TemporaryFile(const fs::path& target)
      : path_(FolderOf(target) /
              (TemporaryStart(target) + std::to_string(platform::ProcessNumber()) + kEnd)) {
    const std::string name = path_.string();
    if (name.size() >= sizeof unfinished_path) return;
    std::memcpy(unfinished_path, name.c_str(), name.size() + 1);
    is_unfinished = true;
  }
  ~TemporaryFile() {
    std::error_code ignored;
    fs::remove(path_, ignored);
    is_unfinished = false;
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

/// Removes temporary files of this output that nobody writes any more. One with the number of this
/// process is from an earlier process that had the same.
void RemoveLeftovers(const fs::path& target) {
  const std::string start = TemporaryStart(target);
  std::error_code error;
  for (auto entry = fs::directory_iterator(FolderOf(target), error);
       !error && entry != fs::directory_iterator(); entry.increment(error)) {
    std::string number = entry->path().filename().string();
    if (!number.starts_with(start) || !number.ends_with(kEnd)) continue;
    number.resize(number.size() - std::strlen(kEnd));
    const auto process = ParseInteger(number.erase(0, start.size()));
    if (!process || *process < 0) continue;
    const bool is_ours = *process == platform::ProcessNumber();
    std::error_code ignored;
    if (is_ours || platform::IsAbandoned(entry->path(), *process)) {
      fs::remove(entry->path(), ignored);
    }
  }
}

/// What can be said against a new file at `target` without making one.
Result<void> CheckPlace(const fs::path& target) {
  const auto refuse = [](std::string why) { return Error{ErrorCode::kOutput, std::move(why)}; };
  if (!target.has_filename()) return refuse("is not the name of a file");
  std::error_code error;
  if (fs::is_symlink(target, error)) return refuse("is a symbolic link that leads nowhere");
  const fs::file_status status = fs::status(target, error);
  if (!fs::status_known(status)) return Outcome(error);
  if (fs::is_directory(status)) return refuse("is a folder");
  if (fs::is_socket(status)) return refuse("is a socket");
  if (!fs::is_directory(FolderOf(target), error)) return refuse("its folder does not exist");
  // A rename asks only the folder, yet a file that is protected is meant to stay.
  return fs::exists(status) ? Outcome(platform::CheckAccess(target)) : Result<void>();
}

}  // namespace

void RemoveUnfinishedOutput() noexcept {
  if (is_unfinished.load()) platform::RemoveFile(unfinished_path);
}

Result<void> CheckWritable(const fs::path& path) {
  if (IsWrittenDirectly(path)) return Outcome(platform::CheckAccess(path));
  const fs::path target = ResolveLinks(path);
  if (Result<void> place = CheckPlace(target); !place) return place;
  const TemporaryFile temporary(target);
  errno = 0;
  const std::ofstream probe(temporary.path());
  return probe ? Result<void>() : Outcome(platform::LastError());
}

Result<void> WriteFileAtomically(const fs::path& path, std::span<const std::byte> bytes) {
  if (IsWrittenDirectly(path)) return Outcome(platform::WriteDevice(path, bytes));
  const fs::path target = ResolveLinks(path);
  if (Result<void> place = CheckPlace(target); !place) return place;

  RemoveLeftovers(target);
  const TemporaryFile temporary(target);
  std::error_code error;
  const fs::perms mode = fs::status(target, error).permissions();  // unknown when there is no file
  error = platform::WriteFile(temporary.path(), mode, bytes);
  if (!error) fs::rename(temporary.path(), target, error);
  // Once the rename is done, a folder that cannot be synced does not undo it.
  if (!error) platform::SyncFolder(FolderOf(target));
  return Outcome(error);
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
