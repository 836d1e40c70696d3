#include "integrators/path.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "geometry/spawn_ray.h"
#include "integrators/registry.h"
#include "sampling/sampler.h"

namespace candela {
namespace {

constexpr uint32_t kUnlimited = std::numeric_limits<uint32_t>::max();
constexpr uint32_t kRouletteAfter = 4;  // Bounces that every path may take.

/// Whether both directions lie on the same side of the true surface. Where a shading normal says
/// otherwise, light would leak through.
bool AreOnOneSide(const SurfacePoint& point, Vec3 wo, Vec3 wi) {
  return Dot(point.n_geometric, wo) * Dot(point.n_geometric, wi) > 0;
}

// What the dimensions of a bounce are used for.
enum BounceUse : uint32_t { kDirection = 0, kRoulette = 2 };

}  // namespace

PathIntegrator::PathIntegrator(const Scene& scene, const IntegratorOptions& options)
    : scene_(scene), bounces_(options.bounces.value_or(kUnlimited)), seed_(options.seed) {
  for (const auto& light : scene.lights()) {
    if (light->IsDelta()) delta_lights_.push_back(light.get());
  }
}

Result<std::unique_ptr<Integrator>> PathIntegrator::Create(const Scene& scene,
                                                           const IntegratorOptions& options) {
  for (size_t i = 0; i < scene.materials().size(); ++i) {
    if (!scene.materials()[i]->IsPhysical()) {
      return Error{
          ErrorCode::kInput,
          fmt::format(
              "material {} has a Phong highlight, or reflects more light than it gets, which "
              "the integrator 'path' does not know; 'whitted' does",
              i)};
    }
  }
  return std::unique_ptr<Integrator>(std::make_unique<PathIntegrator>(scene, options));
}

void PathIntegrator::Trace(std::span<const SampleRequest> samples, Workspace* workspace,
                           std::span<Spectrum> radiance) const {
  for (size_t i = 0; i < samples.size(); ++i) {
    radiance[i] = Radiance(samples[i], &workspace->rays);
  }
  workspace->rays.camera += samples.size();
}

Spectrum PathIntegrator::Radiance(const SampleRequest& request, RayCounts* rays) const {
  const Sampler sampler(seed_, request.x, request.y, request.index);
  Spectrum radiance;
  Spectrum throughput(1);
  Ray ray = scene_.camera().GenerateRay(request.image_point);
  for (uint32_t bounce = 0;; ++bounce) {
    HitRecord hit;
    if (!scene_.Intersect(ray, &hit)) {
      return radiance + throughput * scene_.background().Radiance(ray.direction);
    }
    const SurfacePoint point = scene_.SurfaceAt(ray, hit);
    const Vec3 wo = -Normalize(ray.direction);
    if (const uint32_t lamp = scene_.objects()[hit.object].light; lamp != SceneObject::kNoLight) {
      radiance += throughput * scene_.lights()[lamp]->Emitted(point, wo);
    }
    if (bounce == bounces_) return radiance;

    Bsdf bsdf;
    bsdf.frame =
        Frame::FromNormal(Dot(point.n_shading, wo) < 0 ? -point.n_shading : point.n_shading);
    scene_.material(hit).Evaluate(point, &bsdf);
    radiance += throughput * DirectLight(point, bsdf, wo, rays);

    const uint32_t dimension = BounceDimension(bounce);
    const BsdfSample next = Sample(bsdf, wo, sampler.Get2D(dimension + kDirection));
    throughput *= next.weight;
    if (next.pdf == 0 || throughput.IsBlack() || !AreOnOneSide(point, wo, next.wi)) return radiance;
    if (bounce >= kRouletteAfter) {
      const float survival = std::min(0.95f, throughput.MaxComponent());
      if (sampler.Get1D(dimension + kRoulette) >= survival) return radiance;
      throughput *= Spectrum(1 / survival);
    }
    ray = SpawnRay(point, next.wi);
    ++rays->reflection;
  }
}

Spectrum PathIntegrator::DirectLight(const SurfacePoint& point, const Bsdf& bsdf, Vec3 wo,
                                     RayCounts* rays) const {
  Spectrum sum;
  for (const Light* light : delta_lights_) {
    const LightSample sample = light->SampleIncident(point.p);
    const float cosine = Dot(bsdf.frame.z, sample.direction);
    const Spectrum value = Eval(bsdf, wo, sample.direction);
    if (!(cosine > 0) || value.IsBlack() || !AreOnOneSide(point, wo, sample.direction)) continue;
    ++rays->shadow;
    Ray ray = SpawnRay(point, sample.direction);
    ray.t_max = sample.distance;
    if (!scene_.Occluded(ray)) sum += value * sample.radiance * cosine;
  }
  return sum;
}

}  // namespace candela
