#pragma once

#include <string>
#include <string_view>

#include "base/result.h"

namespace candela::image_reference {

/// What a comparison with every reference picture gave, as a table in Markdown.
std::string ReferenceTable();

/// The part of a document between the lines "<!-- begin: NAME -->" and "<!-- end: NAME -->", and
/// the document with another one in its place. An error when the lines are not there.
Result<std::string> GeneratedPart(std::string_view document, std::string_view name);
Result<std::string> ReplaceGeneratedPart(std::string_view document, std::string_view name,
                                         std::string_view part);

}  // namespace candela::image_reference
