#include "integrators/path_vertex.h"

#include "math/frame.h"

namespace candela {
namespace {

/// The shading normal on the side of the true surface that the direction is on, bent towards the
/// direction where it looks away from it: on round objects of few triangles, near their outline.
Vec3 NormalTowards(const SurfacePoint& point, Vec3 w) {
  constexpr float kLeastCosine = 1e-3f;
  const bool is_outside = Dot(point.OutwardNormal(), w) >= 0;
  const Vec3 n = is_outside ? point.n_shading : -point.n_shading;
  const float cosine = Dot(n, w);
  return cosine > 0 ? n : Normalize(n + w * (kLeastCosine - cosine));
}

}  // namespace

void PathVertex::Evaluate() {
  bsdf.frame = Frame::FromNormal(NormalTowards(point, wo));
  material->Evaluate(point, &bsdf);
}

bool FindMedia(std::span<const Interior> interiors, uint32_t interior, const MediumStack& here,
               RayCounts* rays, PathVertex* vertex) {
  const bool enters = Dot(vertex->point.OutwardNormal(), vertex->wo) >= 0;
  vertex->media_beyond = here;
  if (enters) {
    if (here.IsFull()) ++rays->crowded;
    vertex->media_beyond.Enter(interior);
  } else {
    vertex->media_beyond.Leave(interior);
  }
  if (here.Hides(interiors, interior, enters)) return false;
  if (interiors[interior].is_explicit) {
    const Medium& inside = interiors[interior].medium;
    vertex->bsdf.medium_here = enters ? &here.SeenMedium(interiors) : &inside;
    vertex->bsdf.medium_beyond = enters ? &inside : &vertex->media_beyond.SeenMedium(interiors);
  }
  return true;
}

}  // namespace candela
