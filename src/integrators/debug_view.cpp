#include "integrators/debug_view.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "base/diagnostics.h"
#include "integrators/path.h"
#include "integrators/path_queue.h"
#include "integrators/physical_scene.h"
#include "integrators/registry.h"
#include "integrators/whitted.h"

namespace candela {
namespace {

constexpr DebugViewEntry kViews[] = {
    {"normal", "the shading normal, each part from -1 to 1 as 0 to 1", DebugView::kNormal},
    {"geometric_normal", "the same of the true surface", DebugView::kGeometricNormal},
    {"uv", "the texture coordinates behind the point, as red and green", DebugView::kUv},
    {"albedo", "the colour without light", DebugView::kAlbedo},
    {"object_id", "a colour for each object", DebugView::kObjectId},
    {"material_id", "a colour for each material", DebugView::kMaterialId},
    {"depth", "how near it is, by the size of the scene", DebugView::kDepth},
    {"bounces", "how often the ray goes on, as heat", DebugView::kBounces, true},
    {"cost", "how many rays a sample takes, as heat", DebugView::kCost, true},
};

/// 0 for 0 and 1 for everything: so many are in the middle.
constexpr float kMiddleHeat = 8;

float FractionOf(float x) {
  const float fraction = x - std::floor(x);
  return std::isfinite(fraction) ? fraction : 0;
}

/// Between two neighbours of a list of colours; `position` from 0 to 1 goes through all of it.
Rgb Blend(std::span<const Rgb> colors, float position) {
  const float scaled = position * static_cast<float>(colors.size() - 1);
  const size_t index = std::min(static_cast<size_t>(scaled), colors.size() - 2);
  const float part = scaled - static_cast<float>(index);
  return colors[index] * (1 - part) + colors[index + 1] * part;
}

/// Neighbouring numbers get hues far apart: steps of the golden ratio around the circle, which
/// never come back to where they were, and another brightness for each of three in a row.
Rgb ColorOfNumber(uint32_t number) {
  static constexpr Rgb kHues[] = {{1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 1, 1},
                                  {0, 0, 1}, {1, 0, 1}, {1, 0, 0}};
  constexpr uint32_t kGolden = 2654435769;  // 2^32 over the golden ratio.
  const float hue = static_cast<float>(number * kGolden >> 8) / (1 << 24);
  const float brightness = 1 - 0.2f * static_cast<float>(number % 3);
  return (Blend(kHues, hue) * 0.75f + Rgb{0.25f, 0.25f, 0.25f}) * brightness;
}

/// Black for nothing, then blue, green, yellow, red. The scale is the same for all pictures, so
/// that they can be compared.
Rgb Heat(uint64_t count) {
  static constexpr Rgb kColors[] = {{0, 0, 0}, {0, 0, 1}, {0, 1, 0}, {1, 1, 0}, {1, 0, 0}};
  const auto x = static_cast<float>(count);
  return Blend(kColors, x / (x + kMiddleHeat));
}

Rgb ColorOfNormal(Vec3 n) {
  return n * 0.5f + Vec3{0.5f, 0.5f, 0.5f};
}

}  // namespace

std::span<const DebugViewEntry> DebugViews() {
  return kViews;
}

const DebugViewEntry* FindDebugView(std::string_view name) {
  const auto found = std::ranges::find(kViews, name, &DebugViewEntry::name);
  return found == std::end(kViews) ? nullptr : found;
}

struct DebugIntegrator::Batch final : Workspace {
  PathQueue<uint32_t> paths;             ///< By the number of their sample.
  std::unique_ptr<Workspace> of_worker;  ///< Where effort is shown.
};

DebugIntegrator::DebugIntegrator(const Scene& scene, const IntegratorOptions& options)
    : scene_(scene), view_(options.view), times_(scene, options.seed, options.sampler) {
  const Bounds3 bounds = scene.Bounds();
  const float size = bounds.IsEmpty() ? 0 : Length(bounds.Extent()) / 2;
  if (size > 0 && std::isfinite(size)) middle_depth_ = size;
  if (view_ != DebugView::kBounces && view_ != DebugView::kCost) return;
  Diagnostics unknown;
  CheckPhysical(scene, "path", &unknown);
  if (unknown.HasErrors()) {
    worker_ = WhittedIntegrator::Create(scene, options).value();
  } else {
    worker_ = PathIntegrator::Create(scene, options).value();
  }
}

Result<std::unique_ptr<Integrator>> DebugIntegrator::Create(const Scene& scene,
                                                            const IntegratorOptions& options) {
  return std::unique_ptr<Integrator>(std::make_unique<DebugIntegrator>(scene, options));
}

std::unique_ptr<Workspace> DebugIntegrator::MakeWorkspace() const {
  auto batch = std::make_unique<Batch>();
  if (worker_) batch->of_worker = worker_->MakeWorkspace();
  return batch;
}

void DebugIntegrator::Trace(std::span<const SampleRequest> samples, Workspace* workspace,
                            const SampleOutput& output) const {
  Batch* batch = static_cast<Batch*>(workspace);
  if (worker_) {
    ShowEffort(samples, batch, output);
    return;
  }
  ForEachPart(samples, output, kMostTogether,
              [&](auto part, const SampleOutput& of_part) { ShowSurfaces(part, batch, of_part); });
}

void DebugIntegrator::ShowSurfaces(std::span<const SampleRequest> samples, Batch* batch,
                                   const SampleOutput& output) const {
  PathQueue<uint32_t>& paths = batch->paths;
  paths.Resize(samples.size());
  size_t started = 0;
  for (uint32_t i = 0; i < samples.size(); ++i) {
    paths.states()[i] = i;
    const float time = times_.AreNeeded() ? times_.Draw(samples[i]) : 0;
    paths.rays()[i] = CameraRayAt(scene_, time, samples[i].image_point);
    output.radiance[i] = Spectrum();
    if (paths.rays()[i].direction != Vec3()) paths.MoveTo(started++, i);
  }
  paths.Resize(started);
  batch->rays.camera += started;
  paths.FindHits(scene_, RayOrder::kCoherent);
  for (size_t i = 0; i < paths.size(); ++i) {
    const Ray& ray = paths.rays()[i];
    const HitRecord& hit = paths.hits()[i];
    output.radiance[paths.states()[i]] =
        hit.IsHit() ? Spectrum(ColorOf(ray, hit)) : scene_.background().Radiance(ray.direction);
  }
}

// One sample after the other, since what they take is counted together.
void DebugIntegrator::ShowEffort(std::span<const SampleRequest> samples, Batch* batch,
                                 const SampleOutput& output) const {
  for (size_t i = 0; i < samples.size(); ++i) {
    RayCounts& rays = batch->of_worker->rays;
    rays = RayCounts();
    worker_->Trace(samples.subspan(i, 1), batch->of_worker.get(), {output.radiance.subspan(i, 1)});
    batch->rays += rays;
    output.radiance[i] =
        Spectrum(Heat(view_ == DebugView::kBounces ? rays.reflection : rays.Total()));
  }
}

Rgb DebugIntegrator::ColorOf(const Ray& ray, const HitRecord& hit) const {
  const SceneObject& object = scene_.objects()[hit.object];
  switch (view_) {
    case DebugView::kUv: {
      const Vec2 uv = scene_.TextureCoordinatesAt(ray, hit);
      return {FractionOf(uv.x), FractionOf(uv.y), 0};
    }
    case DebugView::kObjectId:
      return ColorOfNumber(hit.object);
    case DebugView::kMaterialId:
      return ColorOfNumber(object.material);
    default:
      break;
  }
  const SurfacePoint point = scene_.SurfaceAt(ray, hit);
  switch (view_) {
    case DebugView::kNormal:
      return ColorOfNormal(point.n_shading);
    case DebugView::kGeometricNormal:
      return ColorOfNormal(point.n_geometric);
    case DebugView::kAlbedo: {
      const PhongTerms terms = scene_.material(hit).Phong(point);
      return Min(terms.diffuse + terms.specular, Rgb{1, 1, 1});
    }
    default: {
      const float depth = std::max(0.0f, scene_.camera().DepthAt(ray.time, point.p));
      const float nearness = middle_depth_ / (middle_depth_ + depth);
      return {nearness, nearness, nearness};
    }
  }
}

}  // namespace candela
