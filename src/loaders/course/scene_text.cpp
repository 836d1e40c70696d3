#include "loaders/course/scene_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/files.h"
#include "base/text.h"
#include "loaders/course/place_of.h"
#include "loaders/text/nul_check.h"

namespace candela {
namespace fs = std::filesystem;

SceneText::SceneText(std::shared_ptr<const std::string> file, std::string_view text,
                     const fs::path& folder, Diagnostics* diagnostics)
    : diagnostics_(*diagnostics) {
  const fs::path path = folder / (file ? fs::path(*file).filename() : fs::path());
  files_.push_back({path, PlaceOf(path), {}, nullptr, Tokenizer(std::move(file), text)});
}

bool SceneText::Include(const Token& include, const Token* opener) {
  const bool is_block = Peek().IsWord() && PeekSecond().IsOpenBrace();
  if (!Peek().IsWord() || is_block) {
    diagnostics_.Error(Where(Peek()), [&] {
      return fmt::format("{} expects the path of a file, found {}", Quote(include.text),
                         Describe(Peek()));
    });
    return is_block;
  }
  const Token name = Next();
  const SourceLocation asked = Where(name);
  const fs::path path = files_.back().path.parent_path() / name.text;
  if (++includes_ > kMostIncludes) {
    // Files that include each other twice would take for ever.
    if (includes_ == kMostIncludes + 1) {
      diagnostics_.Error(asked, fmt::format("a scene can include at most {} files", kMostIncludes));
    }
    return true;
  }
  if (files_.size() > kDeepest) {
    diagnostics_.Error(asked, fmt::format("files include each other more than {} deep", kDeepest));
    return true;
  }
  Open(path, asked, opener);
  return true;
}

void SceneText::Open(const fs::path& path, const SourceLocation& asked, const Token* opener) {
  const fs::path place = PlaceOf(path);
  if (const std::string circle = CircleTo(place, path); !circle.empty()) {
    diagnostics_.Error(asked, fmt::format("the files include each other in a circle: {}", circle));
    return;
  }
  Result<std::string> text = ReadFile(path);
  if (!text) {
    diagnostics_.Error(asked,
                       fmt::format("include {}: {}", Quote(path.string()), text.error().message),
                       text.error().code);
    return;
  }
  if (places_.insert(place).second) included_.push_back(path);
  const auto file = std::make_shared<const std::string>(path.string());
  auto owned = std::make_shared<const std::string>(*std::move(text));
  if (HasNul(file, *owned, &diagnostics_)) return;
  const auto index = static_cast<uint32_t>(files_.size());
  files_.push_back(
      {path, place, opener ? *opener : Token(), owned, Tokenizer(file, *owned, index)});
}

std::string SceneText::CircleTo(const fs::path& place, const fs::path& path) const {
  const auto first = std::find_if(files_.begin(), files_.end(),
                                  [&](const OpenFile& each) { return each.place == place; });
  if (first == files_.end()) return {};
  std::string circle;
  for (auto file = first; file != files_.end(); ++file) circle += file->path.string() + " -> ";
  return circle + path.string();
}

bool SceneText::IsIncludedIn(const Token* opener) const {
  if (files_.size() == 1) return false;
  const Token& list = files_.back().opener;
  if (!opener || list.IsEnd()) return !opener && list.IsEnd();
  return list.file == opener->file && list.line == opener->line && list.column == opener->column;
}

}  // namespace candela
