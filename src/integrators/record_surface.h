#pragma once

#include "geometry/hit_record.h"
#include "geometry/ray.h"
#include "geometry/surface_point.h"
#include "integrators/integrator.h"
#include "materials/bsdf.h"
#include "sampling/sample_layers.h"
#include "scene/scene.h"

namespace candela {

/// What layers hold of the surface that a camera ray has met; `point` is `Scene::SurfaceAt` of the
/// hit. With `needs_uv` there are texture coordinates also where the material has no use for them.
SampleLayers::Surface RecordSurface(const Scene& scene, const Ray& ray, const HitRecord& hit,
                                    const SurfacePoint& point, bool needs_uv);

/// Records what the ray of a sample has met, as materials of the course describe it.
void RecordCourseSurface(const Scene& scene, const Ray& ray, const HitRecord& hit, uint32_t sample,
                         const SampleOutput& output);

/// About the part of white light that is reflected or let through, by colour: the albedo of diffuse
/// surfaces and of what lies under a coat, the mean reflectance of metals, and the colour of glass,
/// which is white. Holes have none.
Rgb AlbedoOf(const Bsdf& bsdf);

}  // namespace candela
