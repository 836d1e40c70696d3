#include "tests/kernel/degenerate_scenes.h"

namespace candela::test {

const std::vector<DegenerateScene>& DegenerateScenes() {
  static const std::vector<DegenerateScene> all = [] {
    std::vector<DegenerateScene> scenes = DegenerateMeshes();
    const std::vector<DegenerateScene> groups = DegenerateGroups();
    scenes.insert(scenes.end(), groups.begin(), groups.end());
    return scenes;
  }();
  return all;
}

}  // namespace candela::test
