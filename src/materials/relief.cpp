#include "materials/relief.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "textures/texture.h"
#include "textures/texture_input.h"

namespace candela {

ReliefMaterial::ReliefMaterial(std::unique_ptr<Material> material,
                               std::shared_ptr<const Texture> texture, Map map, float height)
    : material_(std::move(material)), texture_(std::move(texture)), map_(map), height_(height) {}

std::unique_ptr<Material> ReliefMaterial::Applied(std::unique_ptr<Material> material,
                                                  ParamReader* params,
                                                  const MaterialContext& context) {
  auto normals = TextureParam(params, "normal_map", context);
  auto heights = TextureParam(params, "bump_map", context);
  const bool has_heights = params->Has("bump_map");
  const float height = has_heights ? params->Number("bump_height", 1) : 0;
  if (has_heights && params->Has("normal_map")) {
    params->Error(params->Where("bump_map"),
                  "a relief is given by 'normal_map' or by 'bump_map', not by both");
  }
  if (!material || (!normals && !heights)) return material;
  if (material->BendsNormals()) {
    params->Error(params->Where(has_heights ? "bump_map" : "normal_map"),
                  "the material that this one is made of has a relief already");
    return material;
  }
  const Map map = normals ? Map::kNormals : Map::kHeights;
  return std::make_unique<ReliefMaterial>(std::move(material), normals ? normals : heights, map,
                                          height);
}

Vec3 ReliefMaterial::NormalOfMap(const SurfacePoint& point) const {
  const Frame frame = Frame::FromNormalAndTangent(point.n_shading, point.dpdu);
  // Coordinates may be mirrored: the map's second axis is where v grows.
  const Vec3 y = Dot(frame.y, point.dpdv) < 0 ? -frame.y : frame.y;
  const Rgb c = texture_->Lookup(point);
  constexpr float kFlattest = 0.05f;  // No facet looks below the horizon.
  return frame.x * (2 * c.x - 1) + y * (2 * c.y - 1) + frame.z * std::max(2 * c.z - 1, kFlattest);
}

// The surface p(u, v) + h(u, v) n has the derivatives dp + dh n, where that of n counts for little.
Vec3 ReliefMaterial::NormalOfHeights(const SurfacePoint& point) const {
  constexpr float kStep = 0x1p-11f;
  const auto height = [&](float du, float dv) {
    SurfacePoint moved = point;
    moved.uv = point.uv + Vec2{du, dv};
    moved.p = point.p + point.dpdu * du + point.dpdv * dv;
    const Rgb c = texture_->Lookup(moved);
    return height_ * (c.x + c.y + c.z) / 3;
  };
  const float along_u = (height(kStep, 0) - height(-kStep, 0)) / (2 * kStep);
  const float along_v = (height(0, kStep) - height(0, -kStep)) / (2 * kStep);
  const Vec3 n = point.n_shading;
  const Vec3 bent = Cross(point.dpdu + n * along_u, point.dpdv + n * along_v);
  return Dot(bent, n) < 0 ? -bent : bent;
}

void ReliefMaterial::Evaluate(const SurfacePoint& point, Bsdf* bsdf) const {
  const Vec3 bent = map_ == Map::kNormals ? NormalOfMap(point) : NormalOfHeights(point);
  const float length2 = LengthSquared(bent);
  if (length2 > 0 && std::isfinite(length2)) {  // Else the coordinates say nothing here.
    const bool is_outside = Dot(point.n_shading, bsdf->frame.z) > 0;
    const Vec3 n = bent * (1 / std::sqrt(length2));
    bsdf->frame = Frame::FromNormalAndTangent(is_outside ? n : -n, point.dpdu);
  }
  material_->Evaluate(point, bsdf);
}

}  // namespace candela
