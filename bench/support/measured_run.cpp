#include "support/measured_run.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "base/clock.h"

namespace candela {
namespace {

double Seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_usec) * 1e-6;
}

}  // namespace

Result<MeasuredRun> Measure(const std::filesystem::path& program,
                            const std::vector<std::string>& arguments) {
  std::vector<char*> words = {const_cast<char*>(program.c_str())};
  for (const std::string& argument : arguments)
    words.push_back(const_cast<char*>(argument.c_str()));
  words.push_back(nullptr);

  const Stopwatch clock;
  pid_t pid = 0;
  posix_spawn_file_actions_t actions;
  ::posix_spawn_file_actions_init(&actions);
  ::posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  const int failure =
      ::posix_spawn(&pid, program.c_str(), &actions, nullptr, words.data(), environ);
  ::posix_spawn_file_actions_destroy(&actions);
  if (failure != 0) {
    return Error{ErrorCode::kInput,
                 fmt::format("{} cannot be started: {}", program.string(), std::strerror(failure))};
  }
  int status = 0;
  rusage usage{};
  while (::wait4(pid, &status, 0, &usage) < 0) {
    if (errno != EINTR) return Error{ErrorCode::kResources, "the process is lost"};
  }
  const double wall = clock.Seconds();
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) {
    return Error{ErrorCode::kInput, fmt::format("{} {} failed with status {}", program.string(),
                                                fmt::join(arguments, " "), status)};
  }
  // Linux counts in units of 1024 bytes.
  return MeasuredRun{wall, Seconds(usage.ru_utime) + Seconds(usage.ru_stime),
                     static_cast<uint64_t>(usage.ru_maxrss) * 1024};
}

}  // namespace candela
