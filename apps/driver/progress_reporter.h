#pragma once

#include <condition_variable>
#include <mutex>
#include <thread>

#include "base/clock.h"
#include "driver/progress_line.h"
#include "render/render_job.h"

namespace candela {

/// Shows on stderr how far a job is, from construction to destruction: on a terminal a bar that is
/// redrawn, elsewhere (TERM=dumb included) a plain line every ten seconds. Nothing at all when
/// `quiet`, or when the work takes less than half a second. NO_COLOR is honoured.
class ProgressReporter {
 public:
  /// The job has to outlive the reporter.
  ProgressReporter(const RenderJob& job, bool quiet);
  ~ProgressReporter();
  ProgressReporter(const ProgressReporter&) = delete;
  ProgressReporter& operator=(const ProgressReporter&) = delete;

 private:
  void RedrawBar();
  void PrintLines();
  bool WaitForEnd(double seconds);
  ProgressState State() const;

  const RenderJob& job_;
  const Stopwatch clock_;
  std::mutex mutex_;
  std::condition_variable ended_;
  bool is_over_ = false;
  std::thread watcher_;
};

}  // namespace candela
