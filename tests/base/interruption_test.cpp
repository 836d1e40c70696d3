// What an output holds after its writer was stopped at any moment.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <chrono>
#include <functional>
#include <random>
#include <thread>

#include "base/clock.h"
#include "base/files.h"
#include "base/signals.h"
#include "tests/support/child.h"
#include "tests/support/temp_folder.h"

namespace candela {
namespace {

using testing::ElementsAre;
using testing_support::Child;
using testing_support::Get;
using testing_support::TempFolder;

const std::string kOne(1 << 20, '1');
const std::string kTwo(3 << 19, '2');

bool Write(const std::filesystem::path& path, const std::string& text) {
  return WriteFileAtomically(path, std::as_bytes(std::span(text))).ok();
}

[[noreturn]] void WriteForEver(const std::filesystem::path& path) {
  while (Write(path, kOne) && Write(path, kTwo)) {
  }
  ::_exit(1);
}

/// Moments spread over the time that a few writes take on this machine.
class Moments {
 public:
  explicit Moments(const std::filesystem::path& path) {
    const Stopwatch watch;
    EXPECT_TRUE(Write(path, kOne) && Write(path, kTwo));
    longest_microseconds_ = static_cast<uint32_t>(2e6 * watch.Seconds()) + 1000;
  }
  void WaitForOne() {
    std::this_thread::sleep_for(std::chrono::microseconds(random_() % longest_microseconds_));
  }

 private:
  std::mt19937 random_{2};
  uint32_t longest_microseconds_;
};

TEST(Interruption, AKillLeavesTheOldContentOrTheNew) {
  const TempFolder folder;
  const auto path = folder / "output";
  // Writes once before the children start: on the portable platform they inherit the number drawn
  // then, and so find each other's leftover at once.
  Moments moments(path);
  // A busy machine may keep the children from writing for long, so there is an upper limit far
  // away.
  int killed_while_writing = 0;
  for (int i = 0; i < 20 || (killed_while_writing == 0 && i < 2000); ++i) {
    Child child([&]() -> int { WriteForEver(path); });
    moments.WaitForOne();
    child.Signal(SIGKILL);
    ASSERT_EQ(child.Wait(), 1000 + SIGKILL);

    const std::string content = Get(path);
    EXPECT_TRUE(content == kOne || content == kTwo) << content.size() << " bytes";
    EXPECT_LE(folder.Names().size(), 2u) << "more than one file left by " << i + 1 << " kills";
    if (folder.Names().size() == 2) ++killed_while_writing;
  }
  EXPECT_GE(killed_while_writing, 1) << "the test never hit a write";
  ASSERT_TRUE(Write(path, kOne));
  EXPECT_THAT(folder.Names(), ElementsAre("output"));
}

/// Sends a stop signal to a process that does `work`, which does not end, at moments of its own.
void StopWhile(Moments* moments, int signal, const std::function<void()>& work) {
  int ready[2];
  ASSERT_EQ(::pipe(ready), 0);
  Child child([&]() -> int {
    ExitOnStopSignals();
    (void)!::write(ready[1], "x", 1);
    work();
    return 1;
  });
  char byte = 0;
  ASSERT_EQ(::read(ready[0], &byte, 1), 1);
  ::close(ready[0]);
  ::close(ready[1]);
  moments->WaitForOne();
  child.Signal(signal);
  ASSERT_EQ(child.Wait(), 128 + signal);
}

TEST(Interruption, AStopSignalLeavesNoTemporaryFile) {
  const TempFolder folder;
  const auto path = folder / "output";
  Moments moments(path);
  for (int i = 0; i < 21; ++i) {
    const int signal = std::array{SIGINT, SIGTERM, SIGHUP}[static_cast<size_t>(i) % 3];
    ASSERT_NO_FATAL_FAILURE(StopWhile(&moments, signal, [&] { WriteForEver(path); }));
    const std::string content = Get(path);
    EXPECT_TRUE(content == kOne || content == kTwo) << content.size() << " bytes";
    EXPECT_THAT(folder.Names(), ElementsAre("output"));
  }
}

// The check makes a file for a moment, too.
TEST(Interruption, AStopSignalDuringTheCheckLeavesNothing) {
  const TempFolder folder;
  Moments moments(folder / "output");
  for (int i = 0; i < 20; ++i) {
    ASSERT_NO_FATAL_FAILURE(StopWhile(&moments, SIGINT, [&] {
      while (CheckWritable(folder / "new")) {
      }
    }));
    ASSERT_THAT(folder.Names(), ElementsAre("output"));
  }
}

TEST(ExitOnStopSignals, KeepsWhatTheParentIgnores) {
  EXPECT_EQ(Child([] {
              std::signal(SIGHUP, SIG_IGN);
              ExitOnStopSignals();
              std::raise(SIGHUP);
              return 7;
            }).Wait(),
            7);
}

TEST(ExitOnStopSignals, TurnsAClosedPipeIntoAnError) {
  EXPECT_EQ(Child([] {
              ExitOnStopSignals();
              int ends[2];
              if (::pipe(ends) != 0 || ::dup2(ends[1], STDOUT_FILENO) < 0) return 1;
              ::close(ends[0]);
              return Write("/dev/stdout", kOne) ? 2 : 7;
            }).Wait(),
            7);
}

}  // namespace
}  // namespace candela
