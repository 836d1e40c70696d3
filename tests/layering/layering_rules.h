#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace candela::layering {

/// Who may include whom, as in docs/architecture.md section 2. A folder may also include itself and
/// what the folders it names may include.
struct Row {
  std::string_view folder;
  std::vector<std::string_view> may_include;
};
const std::vector<Row>& Table();

/// Source text without comments and without what stands inside quotes, lines kept: what is left is
/// code. The path of an include stays.
std::string CodeOf(std::string_view source);

/// The folder of src/ a file belongs to, or "apps"; `path` is relative to the project's root.
std::string FolderOf(std::string_view path);

/// True for "apps" and for every folder of src/ that has its row in the table.
bool IsKnownFolder(std::string_view folder);

/// Every breach of the rules in one file, as "path:line: what is wrong".
std::vector<std::string> Breaches(std::string_view path, std::string_view source);

}  // namespace candela::layering
