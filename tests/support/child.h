#pragma once

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <functional>

namespace candela::testing_support {

/// A copy of this process that runs `body` and ends with the status that it returns. For tests of
/// what ends or restricts a process: signals, users, mounts. Start it while the process has one
/// thread.
class Child {
 public:
  explicit Child(const std::function<int()>& body) : pid_(::fork()) {
    if (pid_ == 0) ::_exit(body());
    if (pid_ < 0) ADD_FAILURE() << "cannot start a process";
  }
  ~Child() {
    if (pid_ > 0) {
      Signal(SIGKILL);
      Wait();
    }
  }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  void Signal(int signal) const { ::kill(pid_, signal); }

  /// The exit status, or 1000 plus the number of the signal that ended it.
  int Wait() {
    int status = 0;
    if (pid_ <= 0 || ::waitpid(pid_, &status, 0) != pid_) return -1;
    pid_ = 0;
    return WIFEXITED(status) ? WEXITSTATUS(status) : 1000 + WTERMSIG(status);
  }

 private:
  pid_t pid_;
};

/// The status of `body` run by a user without special rights: root may write everywhere, so that
/// nothing is refused.
inline int RunAsOrdinaryUser(const std::function<int()>& body) {
  return Child([&] {
           constexpr uid_t kNobody = 65534;
           if (::getuid() == 0 && (::setgid(kNobody) != 0 || ::setuid(kNobody) != 0)) return 99;
           return body();
         })
      .Wait();
}

}  // namespace candela::testing_support
