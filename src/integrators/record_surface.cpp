#include "integrators/record_surface.h"

namespace candela {

SampleLayers::Surface RecordSurface(const Scene& scene, const Ray& ray, const HitRecord& hit,
                                    const SurfacePoint& point, bool needs_uv) {
  const auto towards_camera = [&](Vec3 n) { return Dot(n, ray.direction) > 0 ? -n : n; };
  SampleLayers::Surface surface;
  surface.object = hit.object + 1;
  const SceneObject& object = scene.objects()[hit.object];
  surface.material = object.material + 1;
  surface.depth = scene.camera().DepthAt(ray.time, point.p);
  surface.position = point.p;
  surface.n_shading = towards_camera(point.n_shading);
  surface.n_geometric = towards_camera(point.n_geometric);
  if (needs_uv) {
    surface.uv = object.is_textured ? point.uv : scene.TextureCoordinatesAt(ray, hit);
  }
  return surface;
}

void RecordCourseSurface(const Scene& scene, const Ray& ray, const HitRecord& hit, uint32_t sample,
                         const SampleOutput& output) {
  const SurfacePoint point = scene.SurfaceAt(ray, hit);
  const Material& material = scene.material(hit);
  const PhongTerms terms = material.Phong(point);
  SampleLayers& layers = output.layers[sample];
  layers.albedo =
      Min(terms.diffuse + terms.specular + material.Optics(point).transmittance, Rgb{1, 1, 1});
  if (output.WantsSurface(sample)) {
    layers.surface = RecordSurface(scene, ray, hit, point, output.needs_uv);
  }
}

Rgb AlbedoOf(const Bsdf& bsdf) {
  Rgb albedo;
  for (int i = 0; i < bsdf.count; ++i) {
    const Lobe& lobe = bsdf.lobes[i];
    if (lobe.kind == LobeKind::kHole) continue;
    Rgb weight = lobe.weight.ToRgb() * lobe.share;
    const bool is_metal =
        lobe.kind == LobeKind::kConductor || lobe.kind == LobeKind::kSmoothConductor;
    if (is_metal) weight = weight * lobe.conductor.mean_fresnel;
    albedo += weight;
  }
  return Min(albedo, Rgb{1, 1, 1});
}

}  // namespace candela
