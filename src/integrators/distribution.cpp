#include "integrators/distribution.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/spawn_ray.h"
#include "integrators/beers_law.h"
#include "integrators/course_rays.h"
#include "integrators/distribution_draws.h"
#include "integrators/path_queue.h"
#include "integrators/path_state.h"
#include "integrators/record_surface.h"
#include "integrators/whitted.h"
#include "math/elementary.h"
#include "math/frame.h"
#include "sampling/warp.h"

namespace candela {
namespace {

// After so many bounces light goes one way, where it is both reflected and refracted.
constexpr uint32_t kForks = 4;

/// The first of the dimensions of a ray of that name.
constexpr uint32_t DimensionOf(uint32_t name) {
  return kCameraDimensions + kBounceDimensions * name;
}

/// Of these dimensions those of the choice between two ways.
constexpr uint32_t kChoice = 2;

float Largest(Rgb c) {
  return std::max({c.x, c.y, c.z});
}

bool Mirrors(Rgb weight) {
  return Length(weight) > kLeastMirror;
}

}  // namespace

/// A ray of a tree, on its way.
struct DistributionIntegrator::TreeRay {
  uint32_t sample = 0;    ///< Its place in the list.
  uint32_t index = 0;     ///< Which point of the sequences of its pixel it takes,
  uint32_t name = 0;      ///< and of which sequences.
  uint32_t bounces = 0;   ///< By mirrors and through surfaces,
  uint32_t surfaces = 0;  ///< and by all that it has met.
  bool is_one_of_many = false;
  bool is_gathered = false;  ///< It comes straight from a surface that gathers light,
  Vec3 gathered_from{};      ///< from this point of it.
  bool is_inside = false;    ///< It is in a body,
  Rgb absorption{};          ///< which does this to it.
  Rgb throughput{1, 1, 1};
  Sampler sampler{0, 0, 0, 0};
};

/// What is to be known of the surface that a ray has met, and the light there so far.
struct DistributionIntegrator::Shading {
  Vec3 p, normal;      ///< As the course has them.
  SurfacePoint point;  ///< To start rays from.
  Vec3 eye;            ///< The unit direction that the ray came along,
  Vec3 mirrored;       ///< and that in which it goes on.
  PhongTerms terms;
  PhongOptics optics;
  bool reflects = false;
  Rgb reflection;           ///< What the mirrored rays are multiplied by,
  Rgb refraction;           ///< and the refracted one.
  Vec3 refracted;           ///< A unit vector.
  bool is_outside = false;  ///< The ray came from where the normal points to.
  Rgb light;
};

struct DistributionIntegrator::Batch final : Workspace {
  struct LampLight {
    size_t place;  ///< Of the surface in the list.
    Rgb light;
  };

  std::span<const SampleRequest> samples;
  PathQueue<TreeRay> paths;
  std::vector<Vec2> image_points;
  std::vector<Rgb> sums;  ///< By sample.
  std::vector<Shading> shadings;
  std::vector<LightSample> light_samples;  ///< Of one light without a surface.
  std::vector<LampLight> lamp_lights;      ///< Of one with a surface.
  std::vector<Ray> shadow_rays;
  std::vector<uint8_t> is_shadowed;
  std::vector<TreeRay> next_paths;
  std::vector<Ray> next_rays;

  void Add(const TreeRay& path, uint32_t times_scattered, Rgb light, const SampleOutput& output) {
    if (output.HasLayers()) output.layers[path.sample].AddLight(times_scattered, light);
  }
};

DistributionIntegrator::DistributionIntegrator(const Scene& scene, const IntegratorOptions& options)
    : scene_(scene),
      options_(options),
      bounces_(options.bounces.value_or(WhittedIntegrator::kUsualBounces)) {
  for (uint32_t i = 0; i < scene.lights().size(); ++i) {
    const Light& light = *scene.lights()[i];
    if (!light.IsSurface()) {
      sharp_lights_.push_back(&light);
    } else if (options.light_samples.value_or(0) > 0 && !light.IsFoundByHitsAlone()) {
      lamps_.push_back(i);
    }
  }
  // What they send out has to stay in the cache.
  const uint32_t widest = std::max({1u, options.light_samples.value_or(0), GlossySamples(),
                                    options.indirect_samples.value_or(0)});
  together_ = std::max<size_t>(1, kMostTogether / widest);
}

bool DistributionIntegrator::IsNeeded(const Scene& scene, const IntegratorOptions& options) {
  const auto is_lamp = [](const auto& light) { return light->IsSurface(); };
  const auto has_optics = [](const auto& material) { return material->HasOptics(); };
  return scene.fog() || options.indirect_samples.value_or(0) > 0 ||
         (options.depth_of_field && !scene.camera().IsPinhole()) ||
         (options.light_samples.value_or(0) > 0 && std::ranges::any_of(scene.lights(), is_lamp)) ||
         std::ranges::any_of(scene.materials(), has_optics);
}

std::unique_ptr<Workspace> DistributionIntegrator::MakeWorkspace() const {
  return std::make_unique<Batch>();
}

void DistributionIntegrator::Trace(std::span<const SampleRequest> samples, Workspace* workspace,
                                   const SampleOutput& output) const {
  Batch* batch = static_cast<Batch*>(workspace);
  for (size_t begin = 0; begin < samples.size(); begin += together_) {
    const size_t count = std::min(together_, samples.size() - begin);
    Follow(samples.subspan(begin, count), batch, output.Part(begin, count));
  }
}

void DistributionIntegrator::Follow(std::span<const SampleRequest> samples, Batch* batch,
                                    const SampleOutput& output) const {
  PathQueue<TreeRay>& paths = batch->paths;
  batch->samples = samples;
  batch->sums.assign(samples.size(), Rgb());
  StartRays(batch, output);
  const bool is_pinhole = scene_.camera().IsPinhole() || !options_.depth_of_field;
  RayOrder order = is_pinhole ? RayOrder::kCoherent : RayOrder::kScattered;
  for (bool is_first = true; paths.size() > 0; is_first = false) {
    paths.FindHits(scene_, order);
    EndMisses(batch, output);
    if (is_first && output.HasLayers()) RecordSurfaces(batch, output);
    FindSurfaces(batch, output);
    for (const Light* light : sharp_lights_) AddSharpLight(*light, order, batch);
    for (const uint32_t lamp : lamps_) AddLamp(lamp, batch);
    AddOwnLight(batch, output);
    GoOn(batch);
    order = RayOrder::kScattered;
  }
  for (size_t i = 0; i < samples.size(); ++i) output.radiance[i] = Spectrum(batch->sums[i]);
}

void DistributionIntegrator::StartRays(Batch* batch, const SampleOutput& output) const {
  PathQueue<TreeRay>& paths = batch->paths;
  const std::span<const SampleRequest> samples = batch->samples;
  paths.Resize(samples.size());
  const Camera& camera = scene_.camera();
  const bool is_pinhole = camera.IsPinhole() || !options_.depth_of_field;
  if (is_pinhole) {
    const auto image_points = FirstOf(&batch->image_points, samples.size());
    for (size_t i = 0; i < samples.size(); ++i) image_points[i] = samples[i].image_point;
    camera.GenerateRays(image_points, paths.rays().data());
  }
  size_t started = 0;
  for (uint32_t i = 0; i < samples.size(); ++i) {
    output.Clear(i);
    const SampleRequest& request = samples[i];
    TreeRay& path = paths.states()[i];
    path = TreeRay();
    path.sample = i;
    path.index = request.index;
    path.sampler = Sampler(options_.seed, request.x, request.y, request.index, options_.sampler);
    Ray& ray = paths.rays()[i];
    if (!is_pinhole) {
      ray = camera.GenerateRay(request.image_point, path.sampler.Get2D(kLensDimension));
    }
    if (ray.direction != Vec3()) paths.MoveTo(started++, i);
  }
  paths.Resize(started);
  batch->rays.camera += started;
}

void DistributionIntegrator::Travel(const Ray& ray, double distance, Batch* batch,
                                    const SampleOutput& output, TreeRay* path) const {
  if (path->is_inside) {
    const Spectrum left = std::isinf(distance)
                              ? EndlessTransmittance(path->absorption)
                              : Transmittance(path->absorption, static_cast<float>(distance));
    path->throughput = path->throughput * left.ToRgb();
  } else if (scene_.fog()) {
    const float left = scene_.fog()->Transmittance(ray.origin, Normalize(ray.direction), distance);
    const Rgb added = path->throughput * scene_.fog()->color() * (1 - left);
    batch->sums[path->sample] += added;
    batch->Add(*path, path->surfaces, added, output);
    path->throughput *= left;
  }
}

void DistributionIntegrator::EndMisses(Batch* batch, const SampleOutput& output) const {
  PathQueue<TreeRay>& paths = batch->paths;
  size_t left = 0;
  for (size_t i = 0; i < paths.size(); ++i) {
    if (paths.hits()[i].IsHit()) {
      paths.MoveTo(left++, i);
      continue;
    }
    TreeRay& path = paths.states()[i];
    const Ray& ray = paths.rays()[i];
    Travel(ray, std::numeric_limits<double>::infinity(), batch, output, &path);
    const Rgb background = path.throughput * scene_.background().Radiance(ray.direction).ToRgb();
    batch->Add(path, path.surfaces, background, output);
    batch->sums[path.sample] += background;
  }
  paths.Resize(left);
}

void DistributionIntegrator::RecordSurfaces(Batch* batch, const SampleOutput& output) const {
  PathQueue<TreeRay>& paths = batch->paths;
  for (size_t i = 0; i < paths.size(); ++i) {
    const Ray& ray = paths.rays()[i];
    const HitRecord& hit = paths.hits()[i];
    const uint32_t sample = paths.states()[i].sample;
    const SurfacePoint point = scene_.SurfaceAt(ray, hit);
    SampleLayers& layers = output.layers[sample];
    const PhongTerms terms = scene_.material(hit).Phong(point);
    const Rgb transmittance = scene_.material(hit).Optics(point).transmittance;
    layers.albedo = Min(terms.diffuse + terms.specular + transmittance, Rgb{1, 1, 1});
    if (output.WantsSurface(sample)) {
      layers.surface = RecordSurface(scene_, ray, hit, point, output.needs_uv);
    }
  }
}

void DistributionIntegrator::FindSurfaces(Batch* batch, const SampleOutput& output) const {
  PathQueue<TreeRay>& paths = batch->paths;
  const auto shadings = FirstOf(&batch->shadings, paths.size());
  for (size_t i = 0; i < paths.size(); ++i) {
    const Ray& ray = paths.rays()[i];
    const HitRecord& hit = paths.hits()[i];
    TreeRay& path = paths.states()[i];
    const Material& material = scene_.material(hit);
    Shading& shading = shadings[i] = Shading();
    const SurfacePoint seen = scene_.ShadingAt(ray, hit);
    shading.p = seen.p;
    shading.normal = seen.n_shading;
    shading.point = scene_.SurfaceAt(ray, hit);
    shading.eye = Normalize(ray.direction);
    shading.mirrored = Mirrored(shading.eye, shading.normal);
    shading.terms = material.Phong(seen);
    shading.reflection = shading.terms.specular;
    shading.is_outside = Dot(shading.point.OutwardNormal(), shading.eye) < 0;
    if (material.HasOptics()) {
      PhongOptics& optics = shading.optics = material.Optics(seen);
      if (optics.IsTransparent()) {
        // What meets the back of a surface has come through its body, wherever it began.
        if (!shading.is_outside) {
          path.is_inside = true;
          path.absorption = optics.absorption;
        }
        const Vec3 n = Dot(shading.normal, shading.eye) > 0 ? -shading.normal : shading.normal;
        const Refraction refraction =
            Refract(shading.eye, n, shading.is_outside ? optics.ior : 1 / optics.ior);
        shading.reflection += optics.transmittance * refraction.reflectance;
        shading.refraction = optics.transmittance * (1 - refraction.reflectance);
        shading.refracted = refraction.direction;
      }
    }
    shading.reflects = path.bounces < bounces_ && Mirrors(shading.reflection);
    Travel(ray, double{hit.t} * double{Length(ray.direction)}, batch, output, &path);
  }
}

// As the course does it.
void DistributionIntegrator::AddSharpLight(const Light& light, RayOrder order, Batch* batch) const {
  const size_t count = batch->paths.size();
  const auto samples = FirstOf(&batch->light_samples, count);
  for (size_t i = 0; i < count; ++i) {
    samples[i] = light.SampleIncident(batch->shadings[i].p);
  }
  const auto is_shadowed = FirstOf(&batch->is_shadowed, count);
  if (options_.shadows) {
    const auto rays = FirstOf(&batch->shadow_rays, count);
    for (size_t i = 0; i < count; ++i) {
      StartRay(batch->shadings[i].p, samples[i].direction, kWholeShadowRay,
               ShadowLimit(samples[i].distance), &rays[i]);
    }
    batch->rays.shadow += count;
    scene_.Occluded(order, rays, is_shadowed);
  } else {
    std::ranges::fill(is_shadowed, uint8_t{0});
  }
  for (size_t i = 0; i < count; ++i) {
    if (is_shadowed[i] != 0) continue;
    Shading& shading = batch->shadings[i];
    const Rgb intensity = samples[i].radiance.ToRgb();
    const float cosine = std::max(0.0f, Dot(shading.normal, samples[i].direction));
    const Rgb diffuse = intensity * shading.terms.diffuse * cosine;
    Rgb specular;
    if (shading.terms.specular != Rgb()) {
      specular = intensity * shading.terms.specular *
                 Highlight(Dot(shading.mirrored, samples[i].direction), shading.terms.shininess);
    }
    shading.light += diffuse + specular;
  }
}

// A lamp is as many point lights as there are rays to it, each with its part of the irradiance,
// which a diffuse surface throws back as light does: divided by pi, so that the same comes from
// gathering what shines. Where a mirrored ray goes on it shows the lamp itself, not its highlight.
void DistributionIntegrator::AddLamp(uint32_t number, Batch* batch) const {
  const Light& light = *scene_.lights()[number];
  const uint32_t branch = static_cast<uint32_t>(Branch::kFirstLight) + number;
  batch->lamp_lights.clear();
  batch->shadow_rays.clear();
  for (size_t i = 0; i < batch->paths.size(); ++i) {
    const TreeRay& path = batch->paths.states()[i];
    const Shading& shading = batch->shadings[i];
    const Rgb specular = shading.reflects ? Rgb() : shading.terms.specular;
    if (shading.terms.diffuse == Rgb() && specular == Rgb()) continue;
    const uint32_t count = path.is_one_of_many ? 1 : *options_.light_samples;
    for (uint32_t k = 0; k < count; ++k) {
      const TreeRay drawn = ChildOf(path, branch, count, k, *batch);
      const LightSample sample =
          light.SampleIncident(shading.point.p, drawn.sampler.Get2D(DimensionOf(drawn.name)));
      if (sample.pdf == 0 || sample.radiance.IsBlack()) continue;
      const Rgb intensity = sample.radiance.ToRgb() /
                            (static_cast<float>(kPi) * sample.pdf * static_cast<float>(count));
      Rgb scattered = shading.terms.diffuse * std::max(0.0f, Dot(shading.normal, sample.direction));
      if (specular != Rgb()) {
        scattered +=
            specular * Highlight(Dot(shading.mirrored, sample.direction), shading.terms.shininess);
      }
      if (scattered == Rgb()) continue;
      batch->lamp_lights.push_back({i, intensity * scattered});
      if (!options_.shadows) continue;
      Ray ray = SpawnRay(shading.point, sample.direction);
      ray.t_max = sample.distance;
      ray.mask = kWholeShadowRay;
      batch->shadow_rays.push_back(ray);
    }
  }
  const size_t count = batch->lamp_lights.size();
  if (options_.shadows) {
    batch->rays.shadow += count;
    scene_.Occluded(RayOrder::kScattered, batch->shadow_rays, FirstOf(&batch->is_shadowed, count));
  }
  for (size_t i = 0; i < count; ++i) {
    if (options_.shadows && batch->is_shadowed[i] != 0) continue;
    batch->shadings[batch->lamp_lights[i].place].light += batch->lamp_lights[i].light;
  }
}

bool DistributionIntegrator::Gathers(const TreeRay& path, const Shading& shading) const {
  return options_.indirect_samples.value_or(0) > 0 && !path.is_one_of_many &&
         shading.terms.diffuse != Rgb();
}

// Of the light that is gathered the part that comes from lamps is left out where these are sampled.
Rgb DistributionIntegrator::Emitted(uint32_t number, const TreeRay& path,
                                    const Shading& shading) const {
  const Light& light = *scene_.lights()[number];
  const bool is_sampled = path.is_gathered && std::ranges::count(lamps_, number) > 0 &&
                          light.PdfIncident(path.gathered_from, shading.point, shading.eye) > 0;
  if (is_sampled) return {};
  SurfacePoint surface;
  surface.p = shading.p;
  surface.n_shading = shading.normal;
  return light.Emitted(surface, -shading.eye).ToRgb();
}

void DistributionIntegrator::AddOwnLight(Batch* batch, const SampleOutput& output) const {
  PathQueue<TreeRay>& paths = batch->paths;
  for (size_t i = 0; i < paths.size(); ++i) {
    const TreeRay& path = paths.states()[i];
    const Shading& shading = batch->shadings[i];
    // The ambient light stands for what is gathered.
    const bool has_ambient = !Gathers(path, shading);
    const Rgb ambient =
        has_ambient ? scene_.background().ambient_light * shading.terms.ambient : Rgb();
    Rgb local = shading.light + ambient;
    batch->Add(path, path.surfaces + 1, path.throughput * local, output);
    const uint32_t lamp = scene_.objects()[paths.hits()[i].object].light;
    if (lamp != SceneObject::kNoLight) {
      const Rgb emitted = Emitted(lamp, path, shading);
      local += emitted;
      batch->Add(path, path.surfaces, path.throughput * emitted, output);
    }
    batch->sums[path.sample] += path.throughput * local;
  }
}

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
      const float share = Largest(reflection) / (Largest(reflection) + Largest(refraction));
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
               &reflected);
    } else {
      // By the error bound of the hit: in a small body 0.01 would be a long way.
      Vec3 w = SampleAbout(Normalize(shading.mirrored), roughness,
                           child.sampler.Get2D(DimensionOf(child.name)));
      // What would go into the surface is thrown back once more: no light is lost.
      if (Dot(w, outward) < 0) w = Mirrored(w, outward);
      reflected = SpawnRay(shading.point, w, outward);
      reflected.mask = kReflectionRay;
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
    batch->next_paths.push_back(child);
    batch->next_rays.push_back(ray);
  }
}

}  // namespace candela
