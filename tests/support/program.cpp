#include "tests/support/program.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <pty.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdlib>

#include "base/clock.h"

namespace candela::testing_support {
namespace {

struct Channel {
  int ours = -1, theirs = -1;
};

Channel MakePipe() {
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) ADD_FAILURE() << "cannot make a pipe";
  return {ends[0], ends[1]};
}

Channel MakeTerminal() {
  Channel terminal;
  winsize size{};
  size.ws_row = 24;
  size.ws_col = 80;
  if (::openpty(&terminal.ours, &terminal.theirs, nullptr, nullptr, &size) != 0) {
    ADD_FAILURE() << "cannot make a terminal";
  }
  ::fcntl(terminal.ours, F_SETFD, FD_CLOEXEC);
  ::fcntl(terminal.theirs, F_SETFD, FD_CLOEXEC);
  return terminal;
}

/// The new process becomes the program; only returns when it cannot be started.
void Become(const std::filesystem::path& path, const std::vector<std::string>& arguments,
            const ProgramSetup& setup, int out, int err) {
  ::dup2(out, STDOUT_FILENO);
  ::dup2(err, STDERR_FILENO);
  if (::chdir(setup.folder.c_str()) != 0) return;
  for (const std::string& variable : setup.environment) {
    const size_t equals = variable.find('=');
    ::setenv(variable.substr(0, equals).c_str(), variable.substr(equals + 1).c_str(), 1);
  }
  std::vector<char*> words = {const_cast<char*>(path.c_str())};
  for (const std::string& argument : arguments)
    words.push_back(const_cast<char*>(argument.c_str()));
  words.push_back(nullptr);
  ::execv(path.c_str(), words.data());
}

/// Appends what is there; false at the end of the stream, which a terminal reports as an error.
bool Drain(int* stream, std::string* text) {
  std::array<char, 4096> buffer;
  const ssize_t count = ::read(*stream, buffer.data(), buffer.size());
  if (count > 0) {
    text->append(buffer.data(), static_cast<size_t>(count));
    return true;
  }
  ::close(*stream);
  *stream = -1;
  return false;
}

}  // namespace

Program::Program(const std::filesystem::path& path, const std::vector<std::string>& arguments,
                 const ProgramSetup& setup) {
  const Channel out = MakePipe();
  const Channel err = setup.has_terminal ? MakeTerminal() : MakePipe();
  pid_ = ::fork();
  if (pid_ == 0) {
    Become(path, arguments, setup, out.theirs, err.theirs);
    ::_exit(127);
  }
  if (pid_ < 0) ADD_FAILURE() << "cannot start " << path;
  ::close(out.theirs);
  ::close(err.theirs);
  out_ = out.ours;
  err_ = err.ours;
}

Program::~Program() {
  if (pid_ <= 0) return;
  Signal(SIGKILL);
  Finish();
}

/// Reads what comes within the time; false when nothing is to be expected any more.
bool Program::Read(int milliseconds) {
  std::array<pollfd, 2> streams = {pollfd{out_, POLLIN, 0}, pollfd{err_, POLLIN, 0}};
  if (out_ < 0 && err_ < 0) return false;
  if (::poll(streams.data(), streams.size(), milliseconds) <= 0) return true;
  if (streams[0].revents != 0) Drain(&out_, &end_.out);
  if (streams[1].revents != 0) Drain(&err_, &end_.err);
  return true;
}

bool Program::WaitForError(std::string_view text, double seconds) {
  const Stopwatch clock;
  while (end_.err.find(text) == std::string::npos) {
    if (clock.Seconds() > seconds || !Read(50)) return false;
  }
  return true;
}

void Program::Signal(int signal) const {
  ::kill(pid_, signal);
}

ProgramEnd Program::Finish() {
  while (Read(-1)) {
  }
  int status = 0;
  if (::waitpid(pid_, &status, 0) == pid_) {
    end_.status = WIFEXITED(status) ? WEXITSTATUS(status) : 1000 + WTERMSIG(status);
  }
  pid_ = -1;
  return end_;
}

ProgramEnd RunProgram(const std::filesystem::path& path, const std::vector<std::string>& arguments,
                      const ProgramSetup& setup) {
  return Program(path, arguments, setup).Finish();
}

}  // namespace candela::testing_support
