#include "candela/scene_facts.h"

#include <fmt/format.h>

namespace candela {

SceneFacts::SceneFacts(const LoadedScene& loaded) : materials(loaded.spec.materials.size()) {
  for (const SceneObject& object : loaded.scene->objects()) {
    ++objects;
    ++objects_by_type[object.type];
    if (object.type == "mesh" || object.type == "triangle") {
      triangles += object.shape->PrimitiveCount();
    }
  }
  lights = loaded.scene->lights().size();
  for (const std::string& type : loaded.scene->light_types()) ++lights_by_type[type];
}

std::string Count(uint64_t count, std::string_view noun) {
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

}  // namespace candela
