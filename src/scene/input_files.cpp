#include "scene/input_files.h"

#include "textures/cube_map.h"

namespace candela {

std::vector<std::filesystem::path> ContentFiles(const SceneSpec& spec) {
  std::vector<std::filesystem::path> files = spec.files;
  if (!spec.background.cube_map.empty()) {
    const auto faces = CubeMap::FaceFiles(spec.folder / spec.background.cube_map);
    files.insert(files.end(), faces.begin(), faces.end());
  }
  if (!spec.background.environment.empty()) {
    files.push_back(spec.folder / spec.background.environment);
  }
  for (const TextureSpec& texture : spec.textures) {
    const Param* file = texture.texture.params.Find("file");
    if (texture.texture.type == "image" && file && file->words.size() == 1) {
      files.push_back(spec.folder / spec.PathInScene(file->words[0]));
    }
  }
  for (const NodeSpec& node : spec.nodes) {
    const Param* file = node.light ? node.light->params.Find("file") : nullptr;
    if (file && node.light->type == "ies" && file->words.size() == 1) {
      files.push_back(spec.folder / spec.PathInScene(file->words[0]));
    }
  }
  return files;
}

std::vector<std::filesystem::path> InputFiles(const SceneSpec& spec) {
  std::vector<std::filesystem::path> files = ContentFiles(spec);
  files.insert(files.end(), spec.mtl_files.begin(), spec.mtl_files.end());
  return files;
}

}  // namespace candela
