#include "driver/progress_reporter.h"

#include <fmt/format.h>

#include <chrono>
#include <cstdio>

#include "base/terminal.h"

namespace candela {
namespace {

constexpr double kSecondsBeforeBar = 0.5;
constexpr double kSecondsPerFrame = 0.1;
constexpr double kSecondsPerLine = 10;

}  // namespace

ProgressReporter::ProgressReporter(const RenderJob& job, bool quiet) : job_(job) {
  if (quiet) return;
  watcher_ = std::thread([this] { IsErrorTerminal() ? RedrawBar() : PrintLines(); });
}

ProgressReporter::~ProgressReporter() {
  if (!watcher_.joinable()) return;
  {
    const std::lock_guard lock(mutex_);
    is_over_ = true;
  }
  ended_.notify_one();
  watcher_.join();
}

void ProgressReporter::RedrawBar() {
  const bool colours = !AreColoursUnwanted();
  bool is_over = WaitForEnd(kSecondsBeforeBar);
  if (is_over) return;
  MarkOpenLine(true);
  while (true) {
    // The last column stays free: some terminals begin a new line as soon as it is filled.
    fmt::print(stderr, "\r{}", ProgressBar(State(), ErrorTerminalColumns() - 1, colours));
    std::fflush(stderr);
    if (is_over) break;
    is_over = WaitForEnd(kSecondsPerFrame);
  }
  EndOpenLine();
}

void ProgressReporter::PrintLines() {
  while (!WaitForEnd(kSecondsPerLine)) {
    fmt::print(stderr, "rendering: {}\n", ProgressText(State()));
  }
}

/// Waits so long, but not beyond the end of the work; whether that has come.
bool ProgressReporter::WaitForEnd(double seconds) {
  std::unique_lock lock(mutex_);
  return ended_.wait_for(lock, std::chrono::duration<double>(seconds), [this] { return is_over_; });
}

ProgressState ProgressReporter::State() const {
  return {job_.Progress(), job_.RaysTraced(), clock_.Seconds()};
}

}  // namespace candela
