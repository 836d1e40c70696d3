#include "document_table.h"

#include "base/files.h"
#include "driver/console.h"
#include "driver/picture_files.h"

namespace candela {

Result<void> UpdateDocument(const std::filesystem::path& document, const std::string& name,
                            const std::string& text) {
  const Result<std::string> old = ReadFile(document);
  if (!old) return Error{old.error().code, document.string() + ": " + old.error().message};
  const std::string begin = "<!-- begin: " + name + " -->\n", end = "<!-- end: " + name + " -->\n";
  const size_t first = old->find(begin), last = old->find(end);
  if (first == std::string::npos || last == std::string::npos || last < first) {
    return Error{ErrorCode::kInput, document.string() + ": has no place for the table '" + name +
                                        "': a line '<!-- begin: " + name +
                                        " -->', and below it one with 'end'"};
  }
  return WriteOutput(document, old->substr(0, first) + begin + text + old->substr(last));
}

Result<void> Publish(const std::string& name, const std::string& tables, bool update) {
  if (auto printed = WriteResult(tables); !printed) return printed;
  return update ? UpdateDocument("docs/performance.md", name, tables) : Result<void>();
}

}  // namespace candela
