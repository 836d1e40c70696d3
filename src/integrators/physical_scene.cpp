#include "integrators/physical_scene.h"

#include <fmt/format.h>

#include <vector>

namespace candela {

void CheckPhysical(const Scene& scene, std::string_view integrator, Diagnostics* diagnostics) {
  std::vector<bool> is_checked(scene.materials().size());
  for (const SceneObject& object : scene.objects()) {
    if (is_checked[object.material]) continue;
    is_checked[object.material] = true;
    if (scene.materials()[object.material]->IsPhysical()) continue;
    diagnostics->Error(scene.PlaceOfMaterial(object.material), [&] {
      return fmt::format(
          "the material has a Phong highlight, or reflects more light than it gets, which the "
          "integrator '{}' does not know; 'whitted' does, and so does it 'normalised'",
          integrator);
    });
  }
}

}  // namespace candela
