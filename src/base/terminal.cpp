#include "base/terminal.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <atomic>
#include <cstdlib>
#include <string_view>

namespace candela {
namespace {

std::string_view Variable(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? std::string_view() : std::string_view(value);
}

std::atomic<bool> line_is_open = false;
static_assert(std::atomic<bool>::is_always_lock_free, "signal handlers use it");

}  // namespace

bool IsErrorTerminal() {
  const std::string_view type = Variable("TERM");
  return ::isatty(STDERR_FILENO) != 0 && !type.empty() && type != "dumb";
}

int ErrorTerminalColumns() {
  winsize size{};
  if (::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return 80;
  return size.ws_col;
}

void MarkOpenLine(bool is_open) {
  line_is_open = is_open;
}

void EndOpenLine() noexcept {
  if (!line_is_open.exchange(false)) return;
  // When even this fails there is nobody left to tell.
  [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, "\n", 1);
}

bool AreColoursUnwanted() {
  return !Variable("NO_COLOR").empty();
}

}  // namespace candela
