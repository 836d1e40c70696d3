#pragma once

#include <algorithm>
#include <cstdint>

namespace candela::testing_support {

// How much a test does. Sanitizers look for errors of memory, undefined behaviour and races, which
// a few samples or cases show as well as many, and all is ten times as slow there; how far numbers
// may be off is told by the stage `dev`. A test with a slow counterpart is compiled twice, so that
// the slow set tells smaller differences.

#ifdef CANDELA_SANITIZED
inline constexpr bool kIsSanitized = true;
#else
inline constexpr bool kIsSanitized = false;
#endif

#ifdef CANDELA_SLOW
inline constexpr bool kIsSlow = true;
#else
inline constexpr bool kIsSlow = false;
#endif

/// So many samples; under sanitizers a sixteenth of them, at least four.
constexpr uint32_t Samples(uint32_t usual) {
  return kIsSanitized ? std::max(usual / 16, std::min(usual, 4u)) : usual;
}

/// How large the error of a mean may be, so that no noisy estimate passes by being noisy; under
/// sanitizers as much larger as `Samples` make that of evenly spread samples.
constexpr double LargestError(double usual) {
  return kIsSanitized ? 16 * usual : usual;
}

}  // namespace candela::testing_support
