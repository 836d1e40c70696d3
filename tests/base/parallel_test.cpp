#include "base/parallel.h"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <thread>
#include <vector>

#include "base/cancel_token.h"
#include "tests/support/meeting.h"

namespace candela {
namespace {

using testing_support::Meeting;

class ThreadLimitOf : public testing::TestWithParam<int> {};

TEST_P(ThreadLimitOf, ReallyUsesThatManyThreadsAtOnce) {
  const int count = GetParam();
  const ThreadLimit limit(count);
  ASSERT_EQ(ThreadCount(), count);
  Meeting meeting(static_cast<size_t>(count));
  std::atomic<int> arrived = 0;
  ParallelFor(count, [&](int64_t) { arrived += meeting.Join() ? 1 : 0; });
  EXPECT_EQ(arrived, count);
  EXPECT_EQ(meeting.ThreadsSeen(), static_cast<size_t>(count));
}

TEST_P(ThreadLimitOf, GivesConcurrentCallsDifferentWorkers) {
  const int count = GetParam();
  const ThreadLimit limit(count);
  std::vector<std::atomic<bool>> is_busy(static_cast<size_t>(count));
  std::atomic<int> clashes = 0;
  ParallelForWorkers(1000, [&](int64_t, int worker) {
    if (worker < 0 || worker >= count || is_busy.at(static_cast<size_t>(worker)).exchange(true)) {
      ++clashes;
      return;
    }
    std::this_thread::yield();
    is_busy[static_cast<size_t>(worker)] = false;
  });
  EXPECT_EQ(clashes, 0);
}

TEST_P(ThreadLimitOf, CallsTheBodyOnceForEachIndex) {
  const ThreadLimit limit(GetParam());
  std::vector<std::atomic<int>> calls(10'000);
  ParallelFor(10'000, [&](int64_t i) { ++calls.at(static_cast<size_t>(i)); });
  for (const std::atomic<int>& each : calls) ASSERT_EQ(each, 1);
}

TEST_P(ThreadLimitOf, PassesAnExceptionOn) {
  const ThreadLimit limit(GetParam());
  EXPECT_THROW(ParallelFor(100,
                           [](int64_t i) {
                             if (i == 50) throw std::runtime_error("fifty");
                           }),
               std::runtime_error);
  int after = 0;  // The next loop is not disturbed.
  ParallelFor(1, [&](int64_t) { ++after; });
  EXPECT_EQ(after, 1);
}

TEST_P(ThreadLimitOf, LoopsMayBeNested) {
  const ThreadLimit limit(GetParam());
  std::atomic<int64_t> sum = 0;
  ParallelFor(20, [&](int64_t i) { ParallelFor(20, [&](int64_t j) { sum += 20 * i + j; }); });
  EXPECT_EQ(sum, 399 * 400 / 2);
}

INSTANTIATE_TEST_SUITE_P(Counts, ThreadLimitOf, testing::Values(1, 2, 7),
                         testing::PrintToStringParamName());

TEST(ThreadLimit, EndsWithItsObject) {
  const int before = ThreadCount();
  {
    const ThreadLimit limit(before + 3);
    EXPECT_EQ(ThreadCount(), before + 3);
  }
  EXPECT_EQ(ThreadCount(), before);
  const ThreadLimit none(0);
  EXPECT_EQ(ThreadCount(), before);
}

TEST(ParallelFor, OfNothingDoesNothing) {
  ParallelFor(0, [](int64_t) { FAIL(); });
  ParallelFor(-1, [](int64_t) { FAIL(); });
}

TEST(CancelToken, IsSeenByTheLoop) {
  CancelToken token;
  std::atomic<int> done = 0;
  ParallelFor(1000, [&](int64_t) {
    if (token.IsCancelled()) return;
    if (++done == 10) token.Cancel();
  });
  EXPECT_TRUE(token.IsCancelled());
  EXPECT_LT(done, 1000);
}

}  // namespace
}  // namespace candela
