#include "integrators/path.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "geometry/spawn_ray.h"
#include "integrators/path_queue.h"
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

/// A sample on its way.
struct Path {
  uint32_t sample;  ///< Its place in the list.
  Sampler sampler;
  Spectrum radiance{};
  Spectrum throughput = Spectrum(1);
};

/// Plays Russian roulette after the first bounces: a path that carries little light ends often, and
/// counts for more when it does not.
bool Survives(uint32_t bounce, Path* path) {
  if (bounce < kRouletteAfter) return true;
  const float survival = std::min(0.95f, path->throughput.MaxComponent());
  if (path->sampler.Get1D(BounceDimension(bounce) + kRoulette) >= survival) return false;
  path->throughput *= Spectrum(1 / survival);
  return true;
}

/// A surface that a path has met, and what lights without extent give there so far.
struct Vertex {
  SurfacePoint point;
  Vec3 wo;
  Bsdf bsdf;
  Spectrum light;
};

/// What comes from a light if nothing is in the way.
struct Contribution {
  size_t vertex;
  Spectrum value;
};

}  // namespace

/// What is known of samples that are followed together. A vertex belongs to the path at the same
/// place.
struct PathIntegrator::Batch final : Workspace {
  std::vector<Vertex> vertices;
  std::vector<Contribution> contributions;  ///< Of the light in work,
  std::vector<Ray> shadow_rays;             ///< the rays that each depends on,
  std::vector<uint8_t> is_shadowed;         ///< and whether something is in the way.
  PathQueue<Path> paths;
};

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

std::unique_ptr<Workspace> PathIntegrator::MakeWorkspace() const {
  return std::make_unique<Batch>();
}

void PathIntegrator::Trace(std::span<const SampleRequest> samples, Workspace* workspace,
                           std::span<Spectrum> radiance) const {
  Batch* batch = static_cast<Batch*>(workspace);
  for (size_t begin = 0; begin < samples.size(); begin += kMostTogether) {
    const size_t count = std::min(kMostTogether, samples.size() - begin);
    Follow(samples.subspan(begin, count), batch, radiance.subspan(begin, count));
  }
}

void PathIntegrator::Follow(std::span<const SampleRequest> samples, Batch* batch,
                            std::span<Spectrum> radiance) const {
  PathQueue<Path>& paths = batch->paths;
  paths.Clear();
  for (uint32_t i = 0; i < samples.size(); ++i) {
    const SampleRequest& request = samples[i];
    paths.Add({i, Sampler(seed_, request.x, request.y, request.index)},
              scene_.camera().GenerateRay(request.image_point));
  }
  batch->rays.camera += samples.size();

  RayOrder order = RayOrder::kCoherent;
  for (uint32_t bounce = 0; paths.Size() > 0; ++bounce) {
    paths.FindHits(scene_, order);
    FindVertices(bounce, batch, radiance);
    for (const Light* light : delta_lights_) AddLight(*light, batch);
    Scatter(bounce, batch, radiance);
    order = RayOrder::kScattered;
  }
}

void PathIntegrator::FindVertices(uint32_t bounce, Batch* batch,
                                  std::span<Spectrum> radiance) const {
  PathQueue<Path>& paths = batch->paths;
  batch->vertices.resize(paths.Size());
  size_t left = 0;
  for (size_t i = 0; i < paths.Size(); ++i) {
    const Ray& ray = paths.rays[i];
    const HitRecord& hit = paths.hits[i];
    Path& path = paths.states[i];
    if (!hit.IsHit()) {
      radiance[path.sample] =
          path.radiance + path.throughput * scene_.background().Radiance(ray.direction);
      continue;
    }
    Vertex& vertex = batch->vertices[left];
    vertex.point = scene_.SurfaceAt(ray, hit);
    vertex.wo = -Normalize(ray.direction);
    if (const uint32_t lamp = scene_.objects()[hit.object].light; lamp != SceneObject::kNoLight) {
      path.radiance += path.throughput * scene_.lights()[lamp]->Emitted(vertex.point, vertex.wo);
    }
    if (bounce == bounces_) {
      radiance[path.sample] = path.radiance;
      continue;
    }
    const Vec3 n = vertex.point.n_shading;
    vertex.bsdf = Bsdf();
    vertex.bsdf.frame = Frame::FromNormal(Dot(n, vertex.wo) < 0 ? -n : n);
    scene_.material(hit).Evaluate(vertex.point, &vertex.bsdf);
    vertex.light = Spectrum();
    paths.MoveTo(left++, i);
  }
  paths.Shorten(left);
}

void PathIntegrator::AddLight(const Light& light, Batch* batch) const {
  batch->contributions.clear();
  batch->shadow_rays.clear();
  for (size_t i = 0; i < batch->paths.Size(); ++i) {
    const auto& [point, wo, bsdf, sum] = batch->vertices[i];
    const LightSample sample = light.SampleIncident(point.p);
    const float cosine = Dot(bsdf.frame.z, sample.direction);
    const Spectrum value = Eval(bsdf, wo, sample.direction);
    if (!(cosine > 0) || value.IsBlack() || !AreOnOneSide(point, wo, sample.direction)) continue;
    Ray ray = SpawnRay(point, sample.direction);
    ray.t_max = sample.distance;
    ray.mask = kShadowRay;
    batch->shadow_rays.push_back(ray);
    batch->contributions.push_back({i, value * sample.radiance * cosine});
  }
  batch->rays.shadow += batch->shadow_rays.size();
  batch->is_shadowed.resize(batch->shadow_rays.size());
  scene_.Occluded(RayOrder::kScattered, batch->shadow_rays, batch->is_shadowed);
  for (size_t i = 0; i < batch->contributions.size(); ++i) {
    const Contribution& contribution = batch->contributions[i];
    if (!batch->is_shadowed[i]) batch->vertices[contribution.vertex].light += contribution.value;
  }
}

void PathIntegrator::Scatter(uint32_t bounce, Batch* batch, std::span<Spectrum> radiance) const {
  PathQueue<Path>& paths = batch->paths;
  const uint32_t dimension = BounceDimension(bounce) + kDirection;
  size_t left = 0;
  for (size_t i = 0; i < paths.Size(); ++i) {
    Path& path = paths.states[i];
    const Vertex& vertex = batch->vertices[i];
    path.radiance += path.throughput * vertex.light;

    const BsdfSample next = Sample(vertex.bsdf, vertex.wo, path.sampler.Get2D(dimension));
    path.throughput *= next.weight;
    if (next.pdf == 0 || path.throughput.IsBlack() ||
        !AreOnOneSide(vertex.point, vertex.wo, next.wi) || !Survives(bounce, &path)) {
      radiance[path.sample] = path.radiance;
      continue;
    }
    paths.states[left] = path;
    paths.rays[left] = SpawnRay(vertex.point, next.wi);
    paths.rays[left].mask = kReflectionRay;
    ++left;
  }
  paths.Shorten(left);
  batch->rays.reflection += left;
}

}  // namespace candela
