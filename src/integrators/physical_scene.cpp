#include "integrators/physical_scene.h"

#include <fmt/format.h>

#include <vector>

namespace candela {

void CheckPhysical(const Scene& scene, std::string_view integrator, Diagnostics* diagnostics) {
  if (scene.fog()) {
    diagnostics->Error(scene.PlaceOfFog(), [&] {
      return fmt::format("the integrator '{}' does not know fog; 'whitted' does", integrator);
    });
  }
  std::vector<bool> is_checked(scene.materials().size());
  for (const SceneObject& object : scene.objects()) {
    if (is_checked[object.material]) continue;
    is_checked[object.material] = true;
    const Material& material = *scene.materials()[object.material];
    if (material.IsPhysical()) continue;
    if (material.HasOptics()) {
      diagnostics->Error(scene.PlaceOfMaterial(object.material), [&] {
        return fmt::format(
            "the material has a 'transmittance' or a 'reflection_roughness', which the integrator "
            "'{}' does not know; 'whitted' does",
            integrator);
      });
      continue;
    }
    diagnostics->Error(scene.PlaceOfMaterial(object.material), [&] {
      return fmt::format(
          "the material has a Phong highlight, or reflects more light than it gets, which the "
          "integrator '{}' does not know; 'whitted' does, and so does it 'normalised'",
          integrator);
    });
  }
}

}  // namespace candela
