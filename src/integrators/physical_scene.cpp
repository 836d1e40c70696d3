#include "integrators/physical_scene.h"

#include <fmt/format.h>

namespace candela {

Result<void> CheckPhysical(const Scene& scene, std::string_view integrator) {
  for (size_t i = 0; i < scene.materials().size(); ++i) {
    if (scene.materials()[i]->IsPhysical()) continue;
    return Error{
        ErrorCode::kInput,
        fmt::format("{}: the material has a Phong highlight, or reflects more light than it gets, "
                    "which the "
                    "integrator '{}' does not know; 'whitted' does, and so does it 'normalised'",
                    ToString(scene.PlaceOfMaterial(i)), integrator)};
  }
  return {};
}

}  // namespace candela
