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

namespace {

/// How texture coordinates change along a step in the surface: what solves dpdu du + dpdv dv = step
/// best. Nothing where they do not say.
Vec2 UvAlong(const SurfacePoint& point, Vec3 step) {
  const float uu = LengthSquared(point.dpdu), vv = LengthSquared(point.dpdv);
  const float uv = Dot(point.dpdu, point.dpdv);
  const float determinant = uu * vv - uv * uv;
  if (!(determinant > 1e-12f * uu * vv) || !std::isfinite(determinant)) return {};
  const float u = Dot(point.dpdu, step), v = Dot(point.dpdv, step);
  return {(u * vv - v * uv) / determinant, (v * uu - u * uv) / determinant};
}

/// Half of what the ray stands for, of which a texture gives the mean: as far as it shows details,
/// however the surface is cut into triangles. Not so short that rounding of the place counts. 0
/// when the footprint is unknown.
float HalfStep(const SurfacePoint& point) {
  const Vec3 far = Abs(point.p);
  const float shortest = std::max(far.x, std::max(far.y, far.z)) * 0x1p-17f;
  return point.footprint > 0 ? std::max(point.footprint / 2, shortest) : 0;
}

}  // namespace

// The surface p + h(p) n has the derivatives dp + dh n, where that of n counts for little.
Vec3 ReliefMaterial::NormalOfHeights(const SurfacePoint& point) const {
  const float step = HalfStep(point);
  if (step == 0) return NormalOfHeightsByUv(point);
  const auto height = [&](Vec3 along) {
    SurfacePoint moved = point;
    moved.uv = point.uv + UvAlong(point, along);
    moved.p = point.p + along;
    return HeightAt(moved);
  };
  const Frame frame = Frame::FromNormal(point.n_shading);
  const Vec3 x = frame.x * step, y = frame.y * step;
  const float along_x = (height(x) - height(-x)) / (2 * step);
  const float along_y = (height(y) - height(-y)) / (2 * step);
  return frame.z - frame.x * along_x - frame.y * along_y;
}

Vec3 ReliefMaterial::NormalOfHeightsByUv(const SurfacePoint& point) const {
  constexpr float kStep = 0x1p-11f;
  const auto height = [&](float du, float dv) {
    SurfacePoint moved = point;
    moved.uv = point.uv + Vec2{du, dv};
    moved.p = point.p + point.dpdu * du + point.dpdv * dv;
    return HeightAt(moved);
  };
  const float along_u = (height(kStep, 0) - height(-kStep, 0)) / (2 * kStep);
  const float along_v = (height(0, kStep) - height(0, -kStep)) / (2 * kStep);
  const Vec3 n = point.n_shading;
  const Vec3 bent = Cross(point.dpdu + n * along_u, point.dpdv + n * along_v);
  return Dot(bent, n) < 0 ? -bent : bent;
}

float ReliefMaterial::HeightAt(const SurfacePoint& point) const {
  const Rgb c = texture_->Lookup(point);
  return height_ * (c.x + c.y + c.z) / 3;
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
