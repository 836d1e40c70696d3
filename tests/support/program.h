#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace candela::testing_support {

/// What a program left behind.
struct ProgramEnd {
  int status = -1;  ///< The exit status, or 1000 plus the number of the signal that ended it.
  std::string out, err;
};

/// How a program is started.
struct ProgramSetup {
  std::filesystem::path folder = ".";    ///< Its working directory.
  std::vector<std::string> environment;  ///< "NAME=value", in place of what the test has.
  bool has_terminal = false;             ///< stderr is a terminal of 80 columns, not a pipe.
};

/// A program that runs beside the test, as a user would start it. Killed when the object goes.
class Program {
 public:
  Program(const std::filesystem::path& path, const std::vector<std::string>& arguments,
          const ProgramSetup& setup = {});
  ~Program();
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  /// Waits until its stderr holds `text`; false when it ends or the time is over before.
  bool WaitForError(std::string_view text, double seconds);

  void Signal(int signal) const;

  /// Waits for its end.
  ProgramEnd Finish();

 private:
  bool Read(int milliseconds);

  pid_t pid_ = -1;
  int out_ = -1, err_ = -1;
  ProgramEnd end_;
};

/// Runs a program to its end.
ProgramEnd RunProgram(const std::filesystem::path& path, const std::vector<std::string>& arguments,
                      const ProgramSetup& setup = {});

}  // namespace candela::testing_support
