#include "scene_spec/scene_spec.h"

namespace candela {
namespace fs = std::filesystem;

std::string SceneSpec::PathInScene(const ParamWord& path) const {
  const auto& written_in = path.where.file;
  const bool is_in_scene_file =
      !written_in || written_in == file.file || (file.file && *written_in == *file.file);
  if (path.text.empty() || is_in_scene_file || fs::path(path.text).is_absolute()) return path.text;
  const fs::path from = fs::path(*written_in).parent_path();
  if (from == folder) return path.text;
  // An included file was found by way of the folder, unless by an absolute path.
  const bool is_elsewhere = from.is_absolute() && !folder.is_absolute();
  return ((is_elsewhere ? from : from.lexically_relative(folder)) / path.text).string();
}

}  // namespace candela
