#include "integrators/whitted.h"

#include <cmath>

#include "integrators/ray_story.h"
#include "integrators/registry.h"
#include "math/elementary.h"

namespace candela {
namespace {

// The course moves new rays by this much along themselves, whatever the size of the scene. Its
// pictures depend on the value.
constexpr float kOffset = 0.01f;

// A surface whose specular colour is shorter than this does not mirror.
constexpr float kLeastMirror = 0.01f;

Vec3 Reflect(Vec3 d, Vec3 n) {
  return d - n * (2 * Dot(n, d));
}

/// max(0, cosine) to the power of the shininess, where 0 to the power of 0 is 1.
float Highlight(float cosine, float shininess) {
  if (shininess == 0) return 1;
  return cosine > 0 ? Pow(cosine, shininess) : (shininess > 0 ? 0.0f : Pow(0.0f, shininess));
}

}  // namespace

WhittedIntegrator::WhittedIntegrator(const Scene& scene, uint32_t bounces, bool shadows)
    : scene_(scene), bounces_(bounces), shadows_(shadows) {
  for (const auto& light : scene.lights()) {
    if (light->IsDelta()) delta_lights_.push_back(light.get());
  }
}

Result<std::unique_ptr<Integrator>> WhittedIntegrator::Create(const Scene& scene,
                                                              const IntegratorOptions& options) {
  return std::unique_ptr<Integrator>(
      std::make_unique<WhittedIntegrator>(scene, options.bounces.value_or(0), options.shadows));
}

void WhittedIntegrator::Trace(std::span<const SampleRequest> samples, Workspace* workspace,
                              std::span<Spectrum> radiance) const {
  NoStory nobody;
  for (size_t i = 0; i < samples.size(); ++i) {
    const Ray ray = scene_.camera().GenerateRay(samples[i].image_point);
    radiance[i] = Spectrum(Follow(ray, &workspace->rays, &nobody));
  }
  workspace->rays.camera += samples.size();
}

std::vector<std::string> WhittedIntegrator::Explain(const SampleRequest& sample) const {
  RayStory story(scene_);
  RayCounts rays;
  story.OnResult(Follow(scene_.camera().GenerateRay(sample.image_point), &rays, &story));
  return story.TakeLines();
}

template <class Observer>
Rgb WhittedIntegrator::Follow(Ray ray, RayCounts* rays, Observer* observer) const {
  Rgb radiance;
  Rgb throughput{1, 1, 1};
  for (uint32_t bounce = 0;; ++bounce) {
    HitRecord hit;
    if (!scene_.Intersect(ray, &hit)) {
      const Rgb background = scene_.background().Radiance(ray.direction).ToRgb();
      observer->OnMiss(ray, background);
      return radiance + throughput * background;
    }
    const SurfacePoint surface = scene_.ShadingAt(ray, hit);
    const PhongTerms terms = scene_.material(hit).Phong(surface);
    const Vec3 p = surface.p;
    const Vec3 n = surface.n_shading;
    const Vec3 eye = Normalize(ray.direction);
    observer->OnHit(ray, hit, n, terms);

    Rgb local = Shade(p, n, eye, terms, rays, observer);
    if (const uint32_t lamp = scene_.objects()[hit.object].light; lamp != SceneObject::kNoLight) {
      const Rgb emitted = scene_.lights()[lamp]->Emitted(surface, -eye).ToRgb();
      observer->OnEmission(emitted);
      local += emitted;
    }
    radiance += throughput * local;

    if (!(Length(terms.specular) > kLeastMirror)) {
      observer->OnEnd("does not mirror");
      return radiance;
    }
    if (bounce == bounces_) {
      observer->OnEnd("no bounces are left");
      return radiance;
    }
    throughput = throughput * terms.specular;
    if (throughput == Rgb()) {  // Rounded to 0 after many mirrors: nothing can be added any more.
      observer->OnEnd("reflects, but too little to count");
      return radiance;
    }
    observer->OnReflection(terms.specular);
    const Vec3 reflected = Reflect(ray.direction, n);
    ray = Ray(p + reflected * kOffset, reflected);
    ++rays->reflection;
  }
}

template <class Observer>
Rgb WhittedIntegrator::Shade(Vec3 p, Vec3 normal, Vec3 eye, const PhongTerms& terms,
                             RayCounts* rays, Observer* observer) const {
  const Vec3 reflected = Reflect(eye, normal);
  const bool has_specular = terms.specular != Rgb();
  Rgb sum;
  for (const Light* light : delta_lights_) {
    const LightSample sample = light->SampleIncident(p);
    const bool is_shadowed = shadows_ && IsShadowed(p, sample, rays);
    Rgb diffuse, specular;
    if (!is_shadowed) {
      const Rgb intensity = sample.radiance.ToRgb();
      const float cosine = std::max(0.0f, Dot(normal, sample.direction));
      diffuse = intensity * terms.diffuse * cosine;
      if (has_specular) {
        specular = intensity * terms.specular *
                   Highlight(Dot(reflected, sample.direction), terms.shininess);
      }
      sum += diffuse + specular;
    }
    observer->OnLight(*light, sample, is_shadowed, diffuse, specular);
  }
  const Rgb ambient = scene_.background().ambient_light * terms.ambient;
  observer->OnAmbient(ambient);
  return sum + ambient;
}

bool WhittedIntegrator::IsShadowed(Vec3 p, const LightSample& light, RayCounts* rays) const {
  ++rays->shadow;
  Ray ray(p + light.direction * kOffset, light.direction);
  // A hit exactly as far as the light counts. The distance is that of the unmoved point.
  if (light.distance < ray.t_max) ray.t_max = std::nextafter(light.distance, ray.t_max);
  return scene_.Occluded(ray);
}

}  // namespace candela
