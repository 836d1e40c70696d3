#include "base/terminal.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <cstdlib>
#include <string_view>

namespace candela {
namespace {

std::string_view Variable(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? std::string_view() : std::string_view(value);
}

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

bool AreColoursUnwanted() {
  return !Variable("NO_COLOR").empty();
}

}  // namespace candela
