#pragma once

#include <cstdint>
#include <memory>
#include <string>

namespace candela {

/// A place in an input file. Lines and columns count from 1; 0 means the file as a whole.
struct SourceLocation {
  std::shared_ptr<const std::string> file;  ///< As the user wrote it; null for no file.
  uint32_t line = 0;
  uint32_t column = 0;
};

/// The name of a file for a message: escaped; of a very long one the end, which says the most.
std::string DisplayName(const std::string& file);

/// "file:line:column", or as much of it as is known.
std::string ToString(const SourceLocation& where);

}  // namespace candela
