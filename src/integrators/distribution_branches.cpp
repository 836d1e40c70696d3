// Where the trees of rays go on.

#include <algorithm>

#include "geometry/spawn_ray.h"
#include "integrators/course_rays.h"
#include "integrators/distribution.h"
#include "integrators/distribution_draws.h"
#include "integrators/distribution_tree.h"
#include "math/frame.h"
#include "sampling/warp.h"

namespace candela {
namespace {

// After so many bounces light goes one way, where it is both reflected and refracted.
constexpr uint32_t kForks = 4;

/// Of the dimensions of a ray those of the choice between the two.
constexpr uint32_t kChoice = 2;

}  // namespace

DistributionIntegrator::TreeRay DistributionIntegrator::ChildOf(const TreeRay& path,
                                                                uint32_t branch, uint32_t count,
                                                                uint32_t number,
                                                                const Batch& batch) const {
  TreeRay child = path;
  child.name = NameOf(path.name, branch);
  child.is_gathered = false;
  ++child.surfaces;
  if (count == 1) return child;
  // Those of one ray are neighbours in a sequence, which are evenly spread.
  child.is_one_of_many = true;
  child.index = path.index * count + number;
  const SampleRequest& request = batch.samples[path.sample];
  child.sampler = Sampler(options_.seed, request.x, request.y, child.index, options_.sampler);
  return child;
}

void DistributionIntegrator::GoOn(Batch* batch) const {
  PathQueue<TreeRay>& paths = batch->paths;
  batch->next_paths.clear();
  batch->next_rays.clear();
  for (size_t i = 0; i < paths.size(); ++i) {
    const TreeRay& path = paths.states()[i];
    const Shading& shading = batch->shadings[i];
    if (Gathers(path, shading)) Gather(path, shading, batch);
    if (path.bounces == bounces_) continue;

    Rgb reflection = shading.reflects ? shading.reflection : Rgb();
    Rgb refraction = shading.refraction;
    const bool is_forked = reflection != Rgb() && refraction != Rgb();
    if (is_forked && (path.bounces >= kForks || path.is_one_of_many)) {
      // By magnitudes: the course knows colours that take away.
      const float share = MaxAbs(reflection) / (MaxAbs(reflection) + MaxAbs(refraction));
      if (path.sampler.Get1D(DimensionOf(path.name) + kChoice) < share) {
        reflection = reflection / share;
        refraction = Rgb();
      } else {
        refraction = refraction / (1 - share);
        reflection = Rgb();
      }
    }
    // Rounded to 0 after many mirrors, nothing can be added any more.
    if (path.throughput * reflection != Rgb()) {
      Reflect(path, paths.rays()[i], shading, reflection, batch);
    }
    if (path.throughput * refraction != Rgb()) {
      TreeRay child = ChildOf(path, static_cast<uint32_t>(Branch::kRefraction), 1, 0, *batch);
      child.throughput = path.throughput * refraction;
      ++child.bounces;
      child.is_inside = shading.is_outside;
      child.absorption = shading.is_outside ? shading.optics.absorption : Rgb();
      Ray ray = SpawnRay(shading.point, shading.refracted);
      ray.mask = kReflectionRay;
      ray.time = path.time;
      batch->next_paths.push_back(child);
      batch->next_rays.push_back(ray);
    }
  }
  const size_t count = batch->next_paths.size();
  paths.Resize(count);
  std::ranges::copy(batch->next_paths, paths.states().begin());
  std::ranges::copy(batch->next_rays, paths.rays().begin());
  batch->rays.reflection += count;
}

void DistributionIntegrator::Reflect(const TreeRay& path, const Ray& ray, const Shading& shading,
                                     Rgb weight, Batch* batch) const {
  const float roughness = shading.optics.reflection_roughness;
  const uint32_t count = roughness > 0 && !path.is_one_of_many ? GlossySamples() : 1;
  const Vec3 outward =
      shading.is_outside ? shading.point.OutwardNormal() : -shading.point.OutwardNormal();
  for (uint32_t k = 0; k < count; ++k) {
    TreeRay child = ChildOf(path, static_cast<uint32_t>(Branch::kReflection), count, k, *batch);
    child.throughput = path.throughput * weight;
    if (count > 1) child.throughput = child.throughput / static_cast<float>(count);
    ++child.bounces;
    Ray reflected;
    if (roughness == 0 && !shading.optics.IsTransparent()) {
      StartRay(shading.p, Mirrored(ray.direction, shading.normal), kReflectionRay, Ray().t_max,
               path.time, &reflected);
    } else {
      // By the error bound of the hit: in a small body 0.01 would be a long way.
      Vec3 w = SampleAbout(Normalize(shading.mirrored), roughness,
                           child.sampler.Get2D(DimensionOf(child.name)));
      // What would go into the surface is thrown back once more: no light is lost.
      if (Dot(w, outward) < 0) w = Mirrored(w, outward);
      reflected = SpawnRay(shading.point, w, outward);
      reflected.mask = kReflectionRay;
      reflected.time = path.time;
    }
    batch->next_paths.push_back(child);
    batch->next_rays.push_back(reflected);
  }
}

void DistributionIntegrator::Gather(const TreeRay& path, const Shading& shading,
                                    Batch* batch) const {
  const uint32_t count = *options_.indirect_samples;
  const bool is_uniform = options_.indirect_sampling == IndirectSampling::kUniform;
  const Frame frame = Frame::FromNormal(shading.normal);
  const Rgb throughput = path.throughput * shading.terms.diffuse / static_cast<float>(count);
  for (uint32_t k = 0; k < count; ++k) {
    TreeRay child = ChildOf(path, static_cast<uint32_t>(Branch::kGathering), count, k, *batch);
    const Vec2 u = child.sampler.Get2D(DimensionOf(child.name));
    const Vec3 local = is_uniform ? SampleUniformHemisphere(u) : SampleCosineHemisphere(u);
    const Vec3 w = frame.ToWorld(local);
    if (!(local.z > 0) || !(Dot(w, shading.point.OutwardNormal()) > 0)) continue;
    // The cosine over pi, and over the density.
    child.throughput = throughput * (is_uniform ? 2 * local.z : 1);
    child.is_one_of_many = true;
    child.is_gathered = true;
    child.gathered_from = shading.point.p;
    Ray ray = SpawnRay(shading.point, w);
    ray.mask = kReflectionRay;
    ray.time = path.time;
    batch->next_paths.push_back(child);
    batch->next_rays.push_back(ray);
  }
}

}  // namespace candela
