#include "base/terminal.h"

#include <atomic>
#include <cstdlib>
#include <string_view>

#include "base/platform.h"

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
  return platform::IsErrorTerminal() && !type.empty() && type != "dumb";
}

int ErrorTerminalColumns() {
  const int columns = platform::ErrorTerminalColumns();
  return columns > 0 ? columns : 80;
}

void MarkOpenLine(bool is_open) {
  line_is_open = is_open;
}

void EndOpenLine() noexcept {
  if (line_is_open.exchange(false)) platform::EndErrorTerminalLine();
}

bool AreColoursUnwanted() {
  return !Variable("NO_COLOR").empty();
}

}  // namespace candela
