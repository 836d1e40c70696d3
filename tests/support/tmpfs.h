#pragma once

#include <sched.h>
#include <sys/mount.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <string>

#include "tests/support/temp_folder.h"

namespace candela::testing_support {

/// A file system of its own in memory, for tests of full and read-only disks. Mounted as root, or
/// in a user namespace where the system lets ordinary users have one; `reason` says why it is not
/// there.
class Tmpfs {
 public:
  Tmpfs(const std::filesystem::path& folder, const std::string& options) : folder_(folder) {
    if (::geteuid() != 0) EnterUserNamespace();
    if (::mount("candela-test", folder.c_str(), "tmpfs", 0, options.c_str()) != 0) {
      reason_ =
          std::string("not run: no right to mount a file system (") + std::strerror(errno) + ")";
    }
  }
  ~Tmpfs() {
    if (ok()) ::umount2(folder_.c_str(), MNT_DETACH);
  }
  Tmpfs(const Tmpfs&) = delete;
  Tmpfs& operator=(const Tmpfs&) = delete;

  bool ok() const { return reason_.empty(); }
  const std::string& reason() const { return reason_; }
  bool MakeReadOnly() {
    return ::mount("candela-test", folder_.c_str(), "tmpfs", MS_REMOUNT | MS_RDONLY, nullptr) == 0;
  }

 private:
  /// Gives this process the rights of root over mounts of its own. Where that is refused the mount
  /// will be too, and says why.
  static void EnterUserNamespace() {
    const auto user = std::to_string(::geteuid()), group = std::to_string(::getegid());
    if (::unshare(CLONE_NEWUSER | CLONE_NEWNS) != 0) return;
    Put("/proc/self/uid_map", user + " " + user + " 1");  // A user without a number owns no files.
    Put("/proc/self/setgroups", "deny");
    Put("/proc/self/gid_map", group + " " + group + " 1");
  }

  std::filesystem::path folder_;
  std::string reason_;
};

}  // namespace candela::testing_support
