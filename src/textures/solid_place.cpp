#include "textures/solid_place.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>

#include "math/frame.h"

namespace candela {
namespace {

constexpr std::string_view kSpaces[] = {"object", "world", "uv"};

/// The length at most of what unit vectors become, in the plane of two of them that become `a` and
/// `b`: the larger singular value.
float LargestStretch(Vec3 a, Vec3 b) {
  const float a2 = LengthSquared(a), b2 = LengthSquared(b), across = Dot(a, b);
  const float difference = (a2 - b2) / 2;
  const float square = (a2 + b2) / 2 + std::sqrt(difference * difference + across * across);
  return std::isfinite(square) ? std::sqrt(square) : std::numeric_limits<float>::max();
}

/// A unit vector along the derivative of `p`, as texture coordinates; 0 where they say nothing.
float PerLength(Vec3 derivative) {
  const float length = Length(derivative);
  return length > 0 ? 1 / length : 0;
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
  // Two unit vectors in the surface: what happens to lengths across it does not count.
  Vec3 along_x, along_y;
  if (space_ == Space::kUv) {
    place.p = place_from_space_.Point({point.uv.x, point.uv.y, 0});
    along_x = {PerLength(point.dpdu), 0, 0};
    along_y = {0, PerLength(point.dpdv), 0};
  } else {
    const Frame frame = Frame::FromNormal(point.n_geometric);
    along_x = frame.x;
    along_y = frame.y;
    place.p = point.p;
    if (const auto into_object = IntoObject(point)) {
      place.p = into_object->Point(place.p);
      along_x = into_object->Vector(along_x);
      along_y = into_object->Vector(along_y);
    }
    place.p = place_from_space_.Point(place.p);
  }
  place.size = LargestStretch(place_from_space_.Vector(along_x), place_from_space_.Vector(along_y));
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
