#pragma once

namespace candela {

/// Prints the broken condition with its place and aborts. Only mistakes of our own end here; what a
/// user can cause is reported through `Diagnostics` or `Result`.
[[noreturn]] void CheckFailed(const char* condition, const char* file, int line);

}  // namespace candela

/// Stops the program when a condition that the code relies on does not hold.
#define CHECK(condition) \
  ((condition) ? static_cast<void>(0) : ::candela::CheckFailed(#condition, __FILE__, __LINE__))

/// The same in hot code: checked unless NDEBUG is set.
#ifdef NDEBUG
#define DCHECK(condition) static_cast<void>(0)
#else
#define DCHECK(condition) CHECK(condition)
#endif
