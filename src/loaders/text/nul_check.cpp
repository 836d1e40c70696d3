#include "loaders/text/nul_check.h"

#include <algorithm>
#include <cstdint>

namespace candela {

bool HasNul(const std::shared_ptr<const std::string>& file, std::string_view text,
            Diagnostics* diagnostics) {
  const size_t at = text.find('\0');
  if (at == std::string_view::npos) return false;
  const std::string_view before = text.substr(0, at);
  const auto line_ends = std::count(before.begin(), before.end(), '\n');
  // Where there is no line end, npos + 1 is 0: the line starts with the text.
  const size_t line_start = before.rfind('\n') + 1;
  diagnostics->Error(
      {file, static_cast<uint32_t>(line_ends + 1), static_cast<uint32_t>(at - line_start + 1)},
      "a text file is due, found a NUL byte");
  return true;
}

}  // namespace candela
