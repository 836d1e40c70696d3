#include "driver/console.h"

#include <fmt/format.h>

#include <new>

#include <cerrno>
#include <cstdio>
#include <cstring>

#include "base/text.h"

namespace candela {

Result<void> WriteResult(std::string_view text) {
  // Flushed here, since a full disk or a closed pipe shows only then.
  const bool written =
      std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0;
  if (written) return {};
  return Error{ErrorCode::kOutput,
               fmt::format("standard output cannot be written: {}", std::strerror(errno))};
}

int PrintResult(std::string_view program, std::string_view text) {
  const Result<void> written = WriteResult(text);
  return written ? 0 : PrintError(program, written.error());
}

int PrintError(std::string_view where, const Error& error) {
  fmt::print(stderr, "{}: error: {}\n", EscapeControl(where), error.message);
  return static_cast<int>(error.code);
}

void PrintWarning(std::string_view where, std::string_view message) {
  fmt::print(stderr, "{}: warning: {}\n", EscapeControl(where), message);
}

int RunWithinMemory(std::string_view program, const std::function<int()>& run) {
  try {
    return run();
  } catch (const std::bad_alloc&) {
    return PrintError(program, {ErrorCode::kResources, "the memory is not sufficient"});
  }
}

}  // namespace candela
