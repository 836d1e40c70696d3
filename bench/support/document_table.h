#pragma once

#include <filesystem>
#include <string>

#include "base/result.h"

namespace candela {

/// Puts `text` between the lines `<!-- begin: NAME -->` and `<!-- end: NAME -->` of a document, in
/// place of what stood there.
Result<void> UpdateDocument(const std::filesystem::path& document, const std::string& name,
                            const std::string& text);

/// Prints tables, and with `update` puts them under that name into docs/performance.md.
Result<void> Publish(const std::string& name, const std::string& tables, bool update);

}  // namespace candela
