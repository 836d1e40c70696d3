#include "base/source_location.h"

#include <fmt/format.h>

#include "base/text.h"

namespace candela {

std::string ToString(const SourceLocation& where) {
  if (!where.file) return {};
  const std::string file = EscapeControl(*where.file);
  return where.line == 0 ? file : fmt::format("{}:{}:{}", file, where.line, where.column);
}

}  // namespace candela
