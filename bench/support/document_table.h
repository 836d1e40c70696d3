#pragma once

#include <filesystem>
#include <string>

#include "base/result.h"

namespace candela {

/// Puts `text` between the lines `<!-- begin: NAME -->` and `<!-- end: NAME -->` of a document, in
/// place of what stood there.
Result<void> UpdateDocument(const std::filesystem::path& document, const std::string& name,
                            const std::string& text);

}  // namespace candela
