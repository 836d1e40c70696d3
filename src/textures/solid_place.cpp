#include "textures/solid_place.h"

#include <algorithm>
#include <cmath>
#include <string_view>

namespace candela {
namespace {

constexpr std::string_view kSpaces[] = {"object", "world", "uv"};

/// Texture coordinates for each unit of length, in the direction in which they grow faster.
float UvPerLength(const SurfacePoint& point) {
  const float u = Length(point.dpdu), v = Length(point.dpdv);
  return std::max(u > 0 ? 1 / u : 0, v > 0 ? 1 / v : 0);
}

}  // namespace

SolidPlace SolidPlace::Create(ParamReader* params) {
  return Placed(params, static_cast<Space>(params->Choice("space", kSpaces, 0)));
}

SolidPlace SolidPlace::CreateOfSpace(ParamReader* params) {
  constexpr std::span kOfPoints(kSpaces, 2);
  return Placed(params, static_cast<Space>(params->Choice("space", kOfPoints, 0)));
}

SolidPlace SolidPlace::Placed(ParamReader* params, Space space) {
  SolidPlace place;
  place.space_ = space;
  const Vec3d scale = ToDouble(params->Vector("scale", {1, 1, 1}));
  const Vec3d degrees = ToDouble(params->Vector("rotation", {0, 0, 0}));
  const Vec3d offset = ToDouble(params->Vector("offset", {0, 0, 0}));
  const Mat4 turned = Mat4::Rotate(2, degrees.z) * Mat4::Rotate(1, degrees.y) *
                      Mat4::Rotate(0, degrees.x) * Mat4::Scale(scale);
  place.place_from_space_ = Transform(Mat4::Translate(offset) * turned);
  return place;
}

std::optional<Transform> SolidPlace::IntoObject(const SurfacePoint& point) const {
  if (space_ != Space::kObject || !point.object_space) return std::nullopt;
  const auto ways = point.object_space->At(point.time);
  if (!ways) return std::nullopt;
  return ways->object_from_world;
}

SolidPlace::Place SolidPlace::At(const SurfacePoint& point) const {
  constexpr float kFarthest = 0x1p22f;
  Place place;
  place.size = place_from_space_.LargestStretch();
  if (space_ == Space::kUv) {
    place.p = place_from_space_.Point({point.uv.x, point.uv.y, 0});
    place.size *= UvPerLength(point);
  } else if (const auto into_object = IntoObject(point)) {
    place.p = place_from_space_.Point(into_object->Point(point.p));
    place.size *= into_object->LargestStretch();
  } else {
    place.p = place_from_space_.Point(point.p);
  }
  const Vec3 far = Abs(place.p);
  // Written so that NaN is far away.
  if (!(far.x < kFarthest && far.y < kFarthest && far.z < kFarthest)) place.p = {};
  return place;
}

Vec3 SolidPlace::NormalAt(const SurfacePoint& point) const {
  const auto into_object = IntoObject(point);
  const Vec3 n = into_object ? into_object->Normal(point.n_shading) : point.n_shading;
  return place_from_space_.Normal(n);
}

}  // namespace candela
