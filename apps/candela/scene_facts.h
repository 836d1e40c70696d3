#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>

#include "driver/load_scene.h"

namespace candela {

/// What a scene holds, in numbers.
struct SceneFacts {
  explicit SceneFacts(const LoadedScene& loaded);

  std::map<std::string, uint64_t> objects_by_type, lights_by_type;
  uint64_t objects = 0;  ///< Those that can be hit; singular ones are left out.
  uint64_t triangles =
      0;                ///< Single ones and those of meshes, as often as they stand in the scene.
  uint64_t lights = 0;  ///< Those that shine; ones that are too far away are left out.
  uint64_t materials = 0;  ///< That the scene describes.
};

/// "1 object", "7 objects".
std::string Count(uint64_t count, std::string_view noun);

}  // namespace candela
