// A job that is asked to stop does so soon, however long it would have taken.
#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "base/clock.h"
#include "render/render_job.h"
#include "tests/determinism/test_cases.h"
#include "tests/support/render_scene.h"

namespace candela::determinism {
namespace {

TEST(Cancel, StopsARunningJobInWellUnderASecond) {
  const Subject subject = MakeSubject("whitted", 1);
  ASSERT_TRUE(subject.integrator);
  // Hours of work, and minutes in every tile.
  const Placement placement{"many", SamplePattern::kFilter, 1'000'000};
  const RenderOptions options = OptionsFor(placement, 400, 400);
  RenderJob job(*subject.integrator, options);

  CancelToken cancel;
  Result<void> done;
  std::thread runner([&] { done = job.Run(cancel); });
  while (job.SamplesDone() == 0) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  const Stopwatch clock;
  cancel.Cancel();
  runner.join();
  const double since_cancel = clock.Seconds();

  ASSERT_FALSE(done);
  EXPECT_EQ(done.error().code, ErrorCode::kStopped);
  EXPECT_LT(since_cancel, 0.5);
  EXPECT_LT(job.SamplesDone(), job.SamplesTotal());
}

TEST(Cancel, BeforeTheStartMeansNoRay) {
  const Subject subject = MakeSubject("whitted", 1);
  ASSERT_TRUE(subject.integrator);
  const RenderOptions options = testing_support::WholePicture(50, 50);
  RenderJob job(*subject.integrator, options);
  CancelToken cancel;
  cancel.Cancel();
  const Result<void> done = job.Run(cancel);
  ASSERT_FALSE(done);
  EXPECT_EQ(done.error().code, ErrorCode::kStopped);
  EXPECT_EQ(job.RaysTraced(), 0u);
}

}  // namespace
}  // namespace candela::determinism
