#include "textures/triplanar_texture.h"

#include <algorithm>
#include <cmath>

#include "math/elementary.h"
#include "textures/texture_input.h"

namespace candela {
namespace {

/// Where a picture that is thrown along an axis shows a place, such that nobody outside sees it
/// mirrored; on upright sides up is +y.
Vec2 Thrown(Vec3 p, int axis, bool is_from_above) {
  const float side = is_from_above ? 1.0f : -1.0f;
  if (axis == 0) return {-side * p.z, p.y};
  if (axis == 1) return {p.x, -side * p.z};
  return {side * p.x, p.y};
}

}  // namespace

std::shared_ptr<const Texture> TriplanarTexture::Create(ParamReader* params,
                                                        const TextureContext& context) {
  std::shared_ptr<const Texture> texture;
  if (params->HasRequired("input")) texture = TextureParam(params, "input", context);
  const float sharpness = params->Positive("sharpness", 4);
  const SolidPlace place = SolidPlace::CreateOfSpace(params);
  if (!texture) return nullptr;
  return std::make_shared<TriplanarTexture>(std::move(texture), sharpness, place);
}

Rgb TriplanarTexture::Lookup(const SurfacePoint& point) const {
  const auto [p, size] = place_.At(point);
  const Vec3 n = place_.NormalAt(point);
  const Vec3 steep = Abs(n);
  const float steepest = std::max(steep.x, std::max(steep.y, steep.z));
  const bool is_normal = steepest > 0 && std::isfinite(steepest);

  SurfacePoint thrown = point;
  // A unit of the picture is as long as a unit of the place.
  const float length = size > 0 ? 1 / size : 0;
  thrown.dpdu = {length, 0, 0};
  thrown.dpdv = {0, length, 0};
  Rgb sum;
  float weights = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const float weight = is_normal ? Pow(steep[axis] / steepest, sharpness_) : 1;
    if (!(weight > 0)) continue;
    thrown.uv = Thrown(p, axis, n[axis] > 0);
    sum += texture_->Lookup(thrown) * weight;
    weights += weight;
  }
  return sum * (1 / weights);
}

}  // namespace candela
