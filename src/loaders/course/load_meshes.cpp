#include "loaders/course/load_meshes.h"

#include <filesystem>
#include <map>
#include <memory>

#include "loaders/course/place_of.h"
#include "loaders/obj/obj_reader.h"

namespace candela {
namespace fs = std::filesystem;

void LoadMeshes(SceneSpec* spec, Diagnostics* diagnostics) {
  std::map<fs::path, std::shared_ptr<const MeshSpec>> by_file;
  for (const NodeSpec& node : spec->nodes) {
    if (!node.object || node.object->type != "mesh") continue;
    for (const char* name : {"obj_file", "obj_file_end"}) {
      const Param* param = node.object->params.Find(name);
      if (!param || param->words.size() != 1) continue;  // Reported when the mesh is compiled.
      const ParamWord& word = param->words[0];
      const std::string in_scene = spec->PathInScene(word);
      const auto [mesh, is_new_name] = spec->meshes.try_emplace(in_scene);
      if (!is_new_name) continue;

      const fs::path path = spec->folder / in_scene;
      const auto [loaded, is_new_file] = by_file.try_emplace(PlaceOf(path));
      if (is_new_file) {
        loaded->second = LoadObj(path, word.where, diagnostics, &spec->mtl_files);
        spec->files.push_back(path);
      }
      mesh->second = loaded->second;
    }
  }
}

}  // namespace candela
