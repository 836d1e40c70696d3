#include "loaders/obj/material_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <set>
#include <string_view>
#include <system_error>
#include <vector>

#include "base/files.h"
#include "base/text.h"
#include "loaders/text/line_tokenizer.h"
#include "loaders/text/nul_check.h"

namespace candela {
namespace fs = std::filesystem;
namespace {

constexpr size_t kMostFiles = 64;

using Names = std::set<std::string, std::less<>>;

/// True for paths that cannot lead out of the folder they start in.
bool StaysInside(const fs::path& path) {
  return path.is_relative() && !path.has_root_name() &&
         std::find(path.begin(), path.end(), "..") == path.end();
}

/// An mtllib line may name several files, and a file's name may hold blanks: the whole line is one
/// name when there is such a file, else each word is one.
std::vector<Token> FilesOf(const Token& line, const fs::path& folder) {
  const fs::path whole(line.text);
  std::error_code error;
  if (StaysInside(whole) && fs::exists(folder / whole, error)) return {line};
  std::vector<Token> files;
  LineTokenizer words(line.text);
  for (Token word = words.NextWord(); word.IsWord(); word = words.NextWord()) {
    word.line = line.line;
    word.column += line.column - 1;
    files.push_back(word);
  }
  return files;
}

/// Adds the names of newmtl lines; false when there is a NUL byte.
bool AddNames(const fs::path& path, std::string_view text, Names* names, Diagnostics* diagnostics) {
  if (HasNul(std::make_shared<const std::string>(path.string()), text, diagnostics)) return false;
  LineTokenizer lines(text);
  for (Token keyword = lines.NextLine(); keyword.IsWord(); keyword = lines.NextLine()) {
    if (keyword.text == "newmtl") names->emplace(lines.NextName().text);
  }
  return true;
}

}  // namespace

std::vector<fs::path> CheckMaterials(const ObjContent& content,
                                     const std::shared_ptr<const std::string>& file,
                                     const fs::path& folder, Diagnostics* diagnostics) {
  std::vector<fs::path> read;
  Names names, seen;
  bool have_all = true;
  const auto warn = [&](const Token& where, std::string text) {
    diagnostics->Warning({file, where.line, where.column}, std::move(text));
  };
  for (const Token& line : content.material_files) {
    for (const Token& name : FilesOf(line, folder)) {
      if (!seen.emplace(name.text).second) continue;
      if (seen.size() > kMostFiles) {
        warn(name, fmt::format("more than {} MTL files: the others are not read", kMostFiles));
        return read;
      }
      if (!StaysInside(fs::path(name.text))) {
        warn(name, fmt::format("MTL file {}: only files in the folder of the mesh are read",
                               Quote(name.text)));
        have_all = false;
        continue;
      }
      const fs::path path = folder / name.text;
      const Result<std::string> text = ReadFile(path);
      if (!text) {
        warn(name, fmt::format("MTL file {}: {}", Quote(name.text), text.error().message));
        have_all = false;
        continue;
      }
      read.push_back(path);
      if (!AddNames(path, *text, &names, diagnostics)) have_all = false;
    }
  }
  // The missing names may stand in the missing file.
  if (!have_all) return read;
  std::vector<Token> missing;
  for (const auto& [name, where] : content.used_materials) {
    if (!names.contains(name)) missing.push_back(where);
  }
  std::sort(missing.begin(), missing.end(),
            [](const Token& a, const Token& b) { return a.line < b.line; });
  for (const Token& where : missing) {
    warn(where, fmt::format("no MTL file has a material {}", Quote(where.text)));
  }
  return read;
}

}  // namespace candela
