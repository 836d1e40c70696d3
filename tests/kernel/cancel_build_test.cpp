// A build ends soon after it is told to.
#include <gtest/gtest.h>

#include <ctime>

#include <atomic>
#include <chrono>
#include <cstdio>
#include <string>
#include <thread>

#include "base/cancel_token.h"
#include "tests/kernel/group_description.h"
#include "tests/kernel/trace_lists.h"

namespace candela::test {
namespace {

TEST(CancelBuild, BeforeItBeginsStopsIt) {
  CancelToken cancel;
  cancel.Cancel();
  for (BuildOptions options : AllBuildOptions()) {
    options.cancel = &cancel;
    const auto group = Build(OfMesh(Globe(50, 50)), options);
    ASSERT_FALSE(group.ok()) << ToString(options);
    EXPECT_EQ(group.error().code, ErrorCode::kStopped);
  }
}

TEST(CancelBuild, AtAnyMomentEndsItOneWayOrTheOther) {
  const GroupDescription description = OfMesh(CurvedGrid(60, 0.3f));
  int stopped = 0, built = 0;
  for (int microseconds = 0; microseconds < 20'000; microseconds += 1000) {
    for (const BuildQuality quality : {BuildQuality::kFast, BuildQuality::kBest}) {
      CancelToken cancel;
      BuildOptions options;
      options.quality = quality;
      options.cancel = &cancel;
      std::thread teller([&] {
        std::this_thread::sleep_for(std::chrono::microseconds(microseconds));
        cancel.Cancel();
      });
      const auto group = Build(description, options);
      teller.join();
      ++(group.ok() ? built : stopped);
      if (!group.ok()) {
        EXPECT_EQ(group.error().code, ErrorCode::kStopped);
      }
    }
  }
  EXPECT_EQ(stopped + built, 40);
}

#ifndef CANDELA_SANITIZED

/// Of all threads of this process: unlike the time on the wall, work of other processes is not in
/// it.
double CpuSeconds() {
  timespec time;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_nsec) * 1e-9;
}

// 10 million triangles; told after some work, from another thread. The work that is still done then
// is that of two processors in half a second, at most.
TEST(CancelBuild, OfTenMillionTrianglesStopsWithinASecondOfWork) {
  const GroupDescription description = OfMesh(CurvedGrid(2237, 0.3f));
  struct Moment {
    BuildQuality quality;
    double work;  ///< Seconds of all processors.
  };
  for (const auto& [quality, work] : {Moment{BuildQuality::kFast, 0.05},
                                      {BuildQuality::kFast, 0.4},
                                      {BuildQuality::kFast, 1},
                                      {BuildQuality::kFast, 2},
                                      {BuildQuality::kBest, 1},
                                      {BuildQuality::kBest, 3}}) {
    CancelToken cancel;
    BuildOptions options;
    options.quality = quality;
    options.cancel = &cancel;
    std::atomic<double> told = 0;
    std::atomic<bool> is_over = false;
    const double begin = CpuSeconds();
    std::thread teller([&, work = work] {
      while (CpuSeconds() - begin < work && !is_over) {
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
      }
      told = CpuSeconds();
      cancel.Cancel();
    });
    const auto group = Build(description, options);
    is_over = true;
    const double end = CpuSeconds();
    teller.join();
    ASSERT_FALSE(group.ok()) << "built with " << end - begin << " s of work";
    EXPECT_EQ(group.error().code, ErrorCode::kStopped);
    EXPECT_LT(end - told, 1.0) << ToString(options) << " after " << work << " s";
    std::printf("%s: told after %.2f s of work, stopped %.3f s of work later\n",
                ToString(options).c_str(), told - begin, end - told);
  }
}

#endif

}  // namespace
}  // namespace candela::test
