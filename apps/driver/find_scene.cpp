#include "driver/find_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <system_error>

#include "base/files.h"
#include "base/text.h"

namespace candela {
namespace fs = std::filesystem;
namespace {

/// Adds the names of the entries of `folder` that end like `name`, in alphabetical order.
void AddSimilarFiles(const fs::path& folder, const fs::path& name,
                     std::vector<std::string>* files) {
  const auto first = static_cast<std::ptrdiff_t>(files->size());
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    const fs::path file = entry->path().filename();
    if (file.extension() == name.extension()) files->push_back(file.string());
  }
  std::sort(files->begin() + first, files->end());
}

Error NotFound(const fs::path& name, const std::vector<fs::path>& folders) {
  std::vector<std::string> files;
  AddSimilarFiles(name.has_parent_path() ? name.parent_path() : fs::path("."), name, &files);
  std::string places;
  for (const fs::path& folder : folders) {
    AddSimilarFiles(folder, name, &files);
    places += fmt::format(", in '{}'", EscapeControl(folder.string()));
  }
  const std::vector<std::string_view> candidates(files.begin(), files.end());
  return {ErrorCode::kInput,
          fmt::format("there is no scene {}{}; looked for it as given{}", Quote(name.string()),
                      DidYouMean(name.filename().string(), candidates), places)};
}

}  // namespace

std::vector<fs::path> SceneFolders() {
  const fs::path shipped = fs::path("assets") / "assignment4";
  std::vector<fs::path> folders = {shipped};
  const fs::path program = ExecutableFolder();
  if (!program.empty()) {
    folders.push_back(program / shipped);
    folders.push_back(program.parent_path() / "share" / "candela" / shipped);
  }
  return folders;
}

Result<fs::path> FindScene(const fs::path& name, const std::vector<fs::path>& folders) {
  // What cannot be looked at (a folder without permission) is left to the reader to report.
  std::error_code error;
  if (fs::status(name, error).type() != fs::file_type::not_found) return name;
  if (name.is_absolute()) return NotFound(name, {});
  for (const fs::path& folder : folders) {
    if (fs::exists(folder / name, error)) return folder / name;
  }
  return NotFound(name, folders);
}

}  // namespace candela
