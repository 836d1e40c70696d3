// What a rendering program leaves behind that is stopped at any moment.
#include <array>
#include <chrono>
#include <csignal>
#include <random>
#include <set>
#include <thread>

#include "base/clock.h"
#include "tests/apps/programs.h"

namespace candela::testing_support {
namespace {

using testing::ElementsAre;

/// Two pictures of one scene that take turns in the file o.png.
class StoppedProgram : public ProgramTest {
 protected:
  StoppedProgram() {
    for (int which : {0, 1}) {
      const Stopwatch clock;
      EXPECT_EQ(Assignment4(Arguments(which)).status, 0);
      seconds_ = clock.Seconds();
      pictures_.insert(Bytes("o.png"));
    }
    EXPECT_EQ(pictures_.size(), 2u);
  }

  static std::vector<std::string> Arguments(int which) {
    return {"-input",   "scene.txt",          "-output", "o.png", "-size", "500", "500",
            "-bounces", std::to_string(which)};
  }

  bool HasOneOfThePictures() const { return pictures_.contains(Bytes("o.png")); }

  /// A moment in the given part of `parts` equal ones of a run, start and end included.
  void WaitForMoment(int part, int parts) {
    const double in_part = static_cast<double>(random_() % 1000) / 1000;
    std::this_thread::sleep_for(
        std::chrono::duration<double>(1.2 * seconds_ * (part + in_part) / parts));
  }

 private:
  std::set<std::string> pictures_;
  double seconds_ = 0;
  std::mt19937 random_{3};
};

TEST_F(StoppedProgram, LeavesTheOldPictureOrTheNewWhenKilled) {
  constexpr int kKills = 20;
  int killed = 0;
  for (int i = 0; i < kKills; ++i) {
    Program program(ASSIGNMENT4_PROGRAM, Arguments(i % 2), setup_);
    WaitForMoment(i, kKills);
    program.Signal(SIGKILL);
    killed += program.Finish().status == 1000 + SIGKILL;
    EXPECT_TRUE(HasOneOfThePictures()) << "after kill " << i + 1;
    // The scene, the picture, and one temporary file at most.
    EXPECT_LE(folder_.Names().size(), 3u);
  }
  EXPECT_GE(killed, 1) << "all kills came too late";
  EXPECT_EQ(Assignment4(Arguments(0)).status, 0);
  EXPECT_THAT(folder_.Names(), ElementsAre("o.png", "scene.txt")) << "leftovers stay";
}

TEST_F(StoppedProgram, LeavesNoTemporaryFileOnAStopSignal) {
  constexpr int kSignals = 12;
  int stopped = 0;
  for (int i = 0; i < kSignals; ++i) {
    const int signal = std::array{SIGINT, SIGTERM, SIGHUP}[static_cast<size_t>(i) % 3];
    Program program(ASSIGNMENT4_PROGRAM, Arguments(i % 2), setup_);
    WaitForMoment(i, kSignals);
    program.Signal(signal);
    const int status = program.Finish().status;
    // Before the program has begun the system ends it, after its end there is nothing to stop.
    EXPECT_TRUE(status == 128 + signal || status == 1000 + signal || status == 0) << status;
    stopped += status == 128 + signal;
    EXPECT_TRUE(HasOneOfThePictures());
    EXPECT_THAT(folder_.Names(), ElementsAre("o.png", "scene.txt"));
  }
  EXPECT_GE(stopped, 1) << "all signals came too early or too late";
}

class StopSignal : public ProgramTest, public testing::WithParamInterface<int> {};

TEST_P(StopSignal, EndsALongRenderingWithinASecond) {
  Put(folder_ / "o.png", "old");
  setup_.has_terminal = true;  // The bar tells that rays are being traced.
  Program program(ASSIGNMENT4_PROGRAM,
                  {"-input", "scene.txt", "-output", "o.png", "-size", "6000", "6000", "-jitter",
                   "-bounces", "10", "-shadows"},
                  setup_);
  ASSERT_TRUE(program.WaitForError("%", 60));
  const Stopwatch clock;
  program.Signal(GetParam());
  EXPECT_EQ(program.Finish().status, 128 + GetParam());
  EXPECT_LT(clock.Seconds(), 1);
  EXPECT_TRUE(Bytes("o.png") == "old");
  EXPECT_THAT(folder_.Names(), ElementsAre("o.png", "scene.txt"));
}

INSTANTIATE_TEST_SUITE_P(All, StopSignal, testing::Values(SIGINT, SIGTERM, SIGHUP),
                         testing::PrintToStringParamName());

}  // namespace
}  // namespace candela::testing_support
