#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "geometry/triangle.h"
#include "shapes/mesh.h"

namespace candela {
namespace {

Vec3d Row(const Mat4& a, int i) {
  return {a.m[static_cast<size_t>(i)][0], a.m[static_cast<size_t>(i)][1],
          a.m[static_cast<size_t>(i)][2]};
}

Vec3 Point(const Mat4& a, Vec3 p) {
  const Vec3d v = ToDouble(p);
  const auto coordinate = [&](int i) { return Dot(Row(a, i), v) + a.m[static_cast<size_t>(i)][3]; };
  return ToFloat({coordinate(0), coordinate(1), coordinate(2)});
}

bool IsMirroring(const Mat4& a) {
  return Dot(Row(a, 0), Cross(Row(a, 1), Row(a, 2))) < 0;
}

/// Takes normals along with a surface: by the inverse transpose, in double. Only their directions,
/// and their lengths beside each other, matter, so all of them may be multiplied by a factor.
class NormalMap {
 public:
  explicit NormalMap(const Mat4& object_from_world) : object_from_world_(object_from_world) {}

  /// Tells of a normal before any is asked for.
  void Consider(Vec3 n) {
    const Vec3d v = InDouble(n);
    const double largest = MaxAbs(v);
    if (largest == 0) return;
    longest_ = std::max(longest_, largest);
    shortest_ = std::min(shortest_, largest);
  }

  /// Decides about the factor: 1, but where lengths leave the middle of the range of floats, such
  /// that the longest stay just below its end and short ones keep their digits as long as they can.
  void Finish() {
    if (!(longest_ > kLong || shortest_ < 1 / kLong) || longest_ == 0) return;
    factor_ = std::ldexp(1.0, std::ilogb(kLong) - std::ilogb(longest_));
  }

  Vec3 operator()(Vec3 n) const { return ToFloat(InDouble(n) * factor_); }

 private:
  static constexpr double kLong = 0x1p100;

  Vec3d InDouble(Vec3 n) const {
    const Vec3d v = ToDouble(n);
    return Row(object_from_world_, 0) * v.x + Row(object_from_world_, 1) * v.y +
           Row(object_from_world_, 2) * v.z;
  }

  const Mat4& object_from_world_;
  double longest_ = 0, shortest_ = std::numeric_limits<double>::infinity();
  double factor_ = 1;
};

}  // namespace

std::shared_ptr<const Shape> Mesh::Baked(const Mat4& world_from_object) const {
  const auto object_from_world = InverseAffine(world_from_object);
  if (!object_from_world) return nullptr;
  std::shared_ptr<Mesh> baked(new Mesh());
  baked->spec_ = spec_;
  baked->is_mirrored_ = is_mirrored_ != IsMirroring(world_from_object);

  baked->own_positions_.reserve(positions_.size());
  for (const Vec3 p : positions_) baked->own_positions_.push_back(Point(world_from_object, p));
  baked->positions_ = baked->own_positions_;
  for (const Corners& corners : spec_->triangles) {
    for (const uint32_t corner : corners) {
      if (!IsFinite(baked->positions_[corner])) return nullptr;
    }
  }
  baked->ComputeBounds();
  BakeNormals(*object_from_world, baked.get());
  return baked;
}

void Mesh::BakeNormals(const Mat4& object_from_world, Mesh* baked) const {
  NormalMap to_world(object_from_world);
  for (const Vec3 n : normals_) to_world.Consider(n);
  to_world.Consider({1, 0, 0});  // The normal of a face may be any unit vector.
  to_world.Consider({0, 1, 0});
  to_world.Consider({0, 0, 1});
  to_world.Finish();

  baked->own_normals_.reserve(normals_.size());
  for (const Vec3 n : normals_) baked->own_normals_.push_back(to_world(n));
  baked->normal_corners_ = normal_corners_;
  baked->own_normal_corners_ = own_normal_corners_;
  // A corner without a normal takes that of the face, of unit length in the object. Beside others
  // its length counts, so it becomes one of the normals; alone it is what the face gives anyway.
  std::vector<Corners> corners;
  for (size_t i = 0; i < spec_->triangles.size(); ++i) {
    if (HasNormal(i, 0) == HasNormal(i, 1) && HasNormal(i, 1) == HasNormal(i, 2)) continue;
    if (corners.empty()) corners.assign(normal_corners_.begin(), normal_corners_.end());
    const auto place = static_cast<uint32_t>(baked->own_normals_.size());
    baked->own_normals_.push_back(to_world(FaceNormal(i)));
    for (size_t corner = 0; corner < 3; ++corner) {
      if (!HasNormal(i, corner)) corners[i][corner] = place;
    }
  }
  if (!corners.empty()) {
    baked->own_normal_corners_ = std::make_shared<const std::vector<Corners>>(std::move(corners));
    baked->normal_corners_ = *baked->own_normal_corners_;
  }
  baked->normals_ = baked->own_normals_;
}

}  // namespace candela
