#pragma once

#include <cstdint>
#include <semaphore>
#include <string>
#include <thread>

#include "base/clock.h"

namespace candela {

class RenderJob;

/// How far some work is, at one moment.
struct ProgressState {
  uint64_t done = 0, total = 0;  ///< Samples.
  uint64_t rays = 0;
  double seconds = 0;  ///< Since the start.
};

/// One line of at most `columns` characters: a bar when `with_bar`, percentage, rays per second and
/// the time left. With `with_colour` the bar is wrapped in terminal colours, which do not count.
std::string ProgressLine(const ProgressState& state, int columns, bool with_bar, bool with_colour);

/// Shows on stderr how far a job is, from construction to destruction: on a terminal a bar that is
/// redrawn, elsewhere (or with TERM=dumb) a plain line every ten seconds, and nothing at all when
/// `quiet` or when the work takes less than half a second. NO_COLOR is honoured.
class ProgressReporter {
 public:
  /// The job has to outlive the reporter.
  ProgressReporter(const RenderJob& job, bool quiet);
  ~ProgressReporter();
  ProgressReporter(const ProgressReporter&) = delete;
  ProgressReporter& operator=(const ProgressReporter&) = delete;

 private:
  void Watch();
  ProgressState State() const;

  const RenderJob& job_;
  const Stopwatch clock_;
  std::binary_semaphore stop_{0};
  std::thread watcher_;
};

}  // namespace candela
