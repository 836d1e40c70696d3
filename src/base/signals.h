#pragma once

namespace candela {

/// From now on SIGINT, SIGTERM and SIGHUP end the process at once with status 128 + n, whatever it
/// is doing, after removing the temporary file of an output that is being written and ending a line
/// that is being redrawn. An old output stays as it was, since a new one only takes its place by a
/// rename. A write to a closed pipe becomes an error of that write instead of a signal. For
/// programs, not for libraries.
void ExitOnStopSignals();

}  // namespace candela
