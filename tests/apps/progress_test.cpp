// What long work shows, on a terminal and elsewhere, and how it is stopped.

#include <algorithm>
#include <csignal>

#include "base/clock.h"
#include "tests/apps/programs.h"

namespace candela::testing_support {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

/// Runs on a terminal, where colours are wanted.
class ProgressTest : public ProgramTest {
 protected:
  ProgressTest() {
    setup_.has_terminal = true;
    // The thread sanitizer would let a program that ends go on for a second.
    setup_.environment = {"TERM=xterm", "NO_COLOR=", "TSAN_OPTIONS=atexit_sleep_ms=0"};
  }

  std::vector<std::string> Arguments(int samples) const {
    return {"render", "scene.txt", "-o",
            "o.png",  "--size",    "200",
            "200",    "--samples", std::to_string(samples)};
  }

  /// stderr of a render that is long enough for a bar, to its end. How long a sample takes depends
  /// on the machine, so the number of them grows until it is enough.
  std::string LongRender() const {
    for (int samples = 32; samples < 1 << 20; samples *= 2) {
      const ProgramEnd end = Candela(Arguments(samples));
      EXPECT_EQ(end.status, 0);
      if (!end.err.empty()) return end.err;
    }
    ADD_FAILURE() << "no render was long enough";
    return {};
  }

  /// Work that lasts for days.
  std::vector<std::string> EndlessRender() const { return Arguments(2000000000); }
};

TEST_F(ProgressTest, ATerminalShowsABarThatEndsAtOneHundred) {
  const std::string shown = LongRender();
  EXPECT_THAT(shown, testing::StartsWith("\r\x1b[32m["));
  EXPECT_THAT(shown, HasSubstr("rays/s  "));
  EXPECT_THAT(shown, HasSubstr("\x1b[0m 100%  "));
  EXPECT_THAT(shown, testing::EndsWith("\n"));
  // Redrawn in place: one line in all.
  EXPECT_EQ(std::count(shown.begin(), shown.end(), '\n'), 1);
}

TEST_F(ProgressTest, NoColorLeavesAPlainBar) {
  setup_.environment[1] = "NO_COLOR=1";
  const std::string shown = LongRender();
  EXPECT_THAT(shown, testing::StartsWith("\r["));
  EXPECT_THAT(shown, Not(HasSubstr("\x1b")));
}

TEST_F(ProgressTest, ShortWorkShowsNothing) {
  const ProgramEnd end = Candela({"render", "scene.txt", "-o", "o.png", "--size", "20", "20"});
  EXPECT_EQ(end.status, 0);
  EXPECT_EQ(end.err, "");
}

TEST_F(ProgressTest, QuietWorkShowsNothing) {
  std::vector<std::string> arguments = EndlessRender();
  arguments.push_back("--quiet");
  Program program(CANDELA_PROGRAM, arguments, setup_);
  EXPECT_FALSE(program.WaitForError("%", 2));
  program.Signal(SIGTERM);
  EXPECT_EQ(program.Finish().err, "");
}

// Where no line can be redrawn there is a plain one every ten seconds.
TEST_F(ProgressTest, PlainLinesElsewhere) {
  ProgramSetup pipe = setup_, dumb = setup_;
  pipe.has_terminal = false;
  dumb.environment[0] = "TERM=dumb";
  const Stopwatch clock;
  Program to_pipe(CANDELA_PROGRAM, EndlessRender(), pipe);
  Program to_dumb_terminal(CANDELA_PROGRAM, EndlessRender(), dumb);
  EXPECT_TRUE(to_pipe.WaitForError("\n", 60));
  EXPECT_GT(clock.Seconds(), 9);
  EXPECT_TRUE(to_dumb_terminal.WaitForError("\n", 60));
  for (Program* program : {&to_pipe, &to_dumb_terminal}) {
    program->Signal(SIGKILL);
    EXPECT_THAT(program->Finish().err,
                testing::MatchesRegex("rendering: 0%  [0-9.]+ [kM]?rays/s  .* left\r?\n"));
  }
}

TEST_F(ProgressTest, SignalsStopItWithinASecondAndLeaveTheOldPicture) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    Put(folder_ / "o.png", "the old picture");
    Program program(CANDELA_PROGRAM, EndlessRender(), setup_);
    EXPECT_TRUE(program.WaitForError("%", 60));
    const Stopwatch clock;
    program.Signal(signal);
    const ProgramEnd end = program.Finish();
    EXPECT_LT(clock.Seconds(), 1);
    EXPECT_EQ(end.status, 128 + signal);
    EXPECT_THAT(end.err, testing::EndsWith("\n"));  // The next prompt begins a line.
    EXPECT_EQ(Bytes("o.png"), "the old picture");
    EXPECT_THAT(folder_.Names(), ElementsAre("o.png", "scene.txt"));
  }
}

}  // namespace
}  // namespace candela::testing_support
