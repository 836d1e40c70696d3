#pragma once

#include <string>
#include <vector>

#include "geometry/hit_record.h"
#include "geometry/ray.h"
#include "lights/light.h"
#include "materials/material.h"
#include "scene/scene.h"

namespace candela {

/// Watches `WhittedIntegrator` follow a ray and writes down in words what happens.
class RayStory {
 public:
  explicit RayStory(const Scene& scene) : scene_(scene) {}

  void OnHit(const Ray& ray, const HitRecord& hit, Vec3 normal, const PhongTerms& terms);
  void OnLight(const Light& light, const LightSample& sample, bool is_shadowed, Rgb diffuse,
               Rgb specular);
  void OnAmbient(Rgb ambient);
  void OnEmission(Rgb emitted);
  void OnReflection(Rgb weight);
  void OnMiss(const Ray& ray, Rgb background);
  void OnEnd(const char* why);

  /// What the whole tree of rays comes to.
  void OnResult(Rgb colour);

  std::vector<std::string> TakeLines() { return std::move(lines_); }

 private:
  void Add(std::string text);

  const Scene& scene_;
  std::vector<std::string> lines_;
  size_t depth_ = 0;
};

/// Watches nothing, at no cost.
struct NoStory {
  void OnHit(const Ray&, const HitRecord&, Vec3, const PhongTerms&) {}
  void OnLight(const Light&, const LightSample&, bool, Rgb, Rgb) {}
  void OnAmbient(Rgb) {}
  void OnEmission(Rgb) {}
  void OnReflection(Rgb) {}
  void OnMiss(const Ray&, Rgb) {}
  void OnEnd(const char*) {}
};

}  // namespace candela
