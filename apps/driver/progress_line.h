#pragma once

#include <cstdint>
#include <string>

namespace candela {

/// How far some work is, at one moment.
struct ProgressState {
  double fraction = 0;  ///< In [0, 1].
  uint64_t rays = 0;
  double seconds = 0;  ///< Since the start.
};

/// Percentage, rays per second and the time left, or the time taken at the end:
/// "42%  3.1 Mrays/s  1 min 05 s left".
std::string ProgressText(const ProgressState& state);

/// The same after a bar, in exactly `columns` characters; in too few there is no bar, and the text
/// is cut. With `colours` the bar stands between escape sequences, which do not count.
std::string ProgressBar(const ProgressState& state, int columns, bool colours);

}  // namespace candela
