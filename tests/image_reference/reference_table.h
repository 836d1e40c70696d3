#pragma once

#include <string>

namespace candela::image_reference {

/// What a comparison with every reference picture gave, as a table in Markdown.
std::string ReferenceTable();

}  // namespace candela::image_reference
