#pragma once

#include "base/cancel_token.h"

namespace candela {

/// From now on SIGINT, SIGTERM and SIGHUP end the process at once with status 128 + n, whatever it
/// is doing, after removing the temporary file of an output that is being written and ending a line
/// that is being redrawn. An old output stays as it was, since a new one only takes its place by a
/// rename. A write to a closed pipe becomes an error of that write instead of a signal. For
/// programs, not for libraries.
void ExitOnStopSignals();

/// While this lives, the first SIGINT, SIGTERM or SIGHUP sets a token instead, so that what was
/// done can be saved; the next one ends the process as `ExitOnStopSignals` says. One at a time, in
/// a program that has called that.
class CancelOnStopSignals {
 public:
  explicit CancelOnStopSignals(CancelToken* token);
  ~CancelOnStopSignals();
  CancelOnStopSignals(const CancelOnStopSignals&) = delete;
  CancelOnStopSignals& operator=(const CancelOnStopSignals&) = delete;
};

}  // namespace candela
