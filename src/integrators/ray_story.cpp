#include "integrators/ray_story.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace candela {
namespace {

std::string ToText(Vec3 v) {
  v += Vec3();  // Turns -0 into 0.
  return fmt::format("({:.5g}, {:.5g}, {:.5g})", v.x, v.y, v.z);
}

}  // namespace

void RayStory::Add(std::string text) {
  // Of many thousand reflections the indent would take more memory than the words.
  constexpr size_t kDeepestIndent = 20;
  lines_.push_back(std::string(2 * std::min(depth_, kDeepestIndent), ' ') + std::move(text));
}

void RayStory::OnHit(const Ray& ray, const HitRecord& hit, Vec3 normal, const PhongTerms& terms) {
  const SceneObject& object = scene_.objects()[hit.object];
  Add(fmt::format("ray from {} towards {}", ToText(ray.origin), ToText(ray.direction)));
  Add(fmt::format("hits the {}{} at distance {:.6g}, point {}, normal {}", object.description,
                  object.shape->PrimitiveCount() > 1 ? fmt::format(", triangle {}", hit.primitive)
                                                     : std::string(),
                  hit.t * Length(ray.direction), ToText(ray.At(hit.t)), ToText(normal)));
  Add(fmt::format("material {}: diffuse {}, specular {}, shininess {:.5g}", object.material,
                  ToText(terms.diffuse), ToText(terms.specular), terms.shininess));
}

void RayStory::OnLight(const Light& light, const LightSample& sample, bool is_shadowed, Rgb diffuse,
                       Rgb specular) {
  size_t index = 0;
  while (scene_.lights()[index].get() != &light) ++index;
  Add(fmt::format("light {} from direction {}, intensity {}: {}", index, ToText(sample.direction),
                  ToText(sample.radiance.ToRgb()),
                  is_shadowed ? "in shadow"
                              : fmt::format("diffuse adds {}, specular adds {}", ToText(diffuse),
                                            ToText(specular))));
}

void RayStory::OnAmbient(Rgb ambient) {
  Add("ambient light adds " + ToText(ambient));
}

void RayStory::OnEmission(Rgb emitted) {
  Add("its own light adds " + ToText(emitted));
}

void RayStory::OnReflection(Rgb weight) {
  Add("reflects, weighted with " + ToText(weight) + ":");
  ++depth_;
}

void RayStory::OnMiss(const Ray& ray, Rgb background) {
  Add(fmt::format("ray from {} towards {}", ToText(ray.origin), ToText(ray.direction)));
  Add(fmt::format("hits nothing and sees the background, {}", ToText(background)));
}

void RayStory::OnEnd(const char* why) {
  Add(why);
}

void RayStory::OnResult(Rgb colour) {
  depth_ = 0;
  Add("all together: " + ToText(colour));
}

}  // namespace candela
