#include "base/source_location.h"

#include <fmt/format.h>

#include "base/text.h"

namespace candela {

std::string DisplayName(const std::string& file) {
  constexpr size_t kLongest = 300;  // A line of 500 characters keeps room for what is wrong.
  std::string name = EscapeControl(file);
  if (name.size() <= kLongest) return name;
  size_t start = name.size() - (kLongest - 3);
  while (IsUtf8Continuation(name[start])) ++start;
  return "..." + name.substr(start);
}

std::string ToString(const SourceLocation& where) {
  if (!where.file) return {};
  const std::string file = DisplayName(*where.file);
  return where.line == 0 ? file : fmt::format("{}:{}:{}", file, where.line, where.column);
}

}  // namespace candela
