#include "scene_spec/scene_spec.h"

#include <algorithm>

namespace candela {
namespace fs = std::filesystem;
namespace {

bool BeginsWith(const fs::path& path, const fs::path& folder) {
  return path.is_absolute() == folder.is_absolute() &&
         std::mismatch(folder.begin(), folder.end(), path.begin(), path.end()).first ==
             folder.end();
}

}  // namespace

bool SceneSpec::IsInSceneFile(const SourceLocation& where) const {
  return !where.file || where.file == file.file || (file.file && *where.file == *file.file);
}

std::string SceneSpec::PathInScene(const ParamWord& path) const {
  if (path.text.empty() || IsInSceneFile(path.where) || fs::path(path.text).is_absolute()) {
    return path.text;
  }
  const fs::path from = fs::path(*path.where.file).parent_path();
  if (from == folder) return path.text;
  // An included file was found by way of the folder, unless by an absolute path. To that no way
  // leads back from the folder: when this is a symbolic link, its parent is not the one that it
  // seems to have.
  return ((BeginsWith(from, folder) ? from.lexically_relative(folder) : from) / path.text).string();
}

}  // namespace candela
