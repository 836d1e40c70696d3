#include <algorithm>

#include "sampling/spherical_triangle.h"
#include "sampling/warp.h"
#include "shapes/surface_sampler.h"
#include "shapes/triangle.h"

namespace candela {
namespace {

/// By solid angle; by area from afar.
class TriangleSampler final : public SurfaceSampler {
 public:
  TriangleSampler(Vec3 a, Vec3 b, Vec3 c, Vec3 n)
      : a_(a), b_(b), c_(c), center_((a + b + c) * (1.0f / 3)), n_(n) {
    area_ = Length(TriangleCross(a, b, c)) / 2;
    size_ = std::max({Length(b - a), Length(c - a), Length(c - b)});
  }

  SurfaceSample Sample(Vec3 from, Vec2 u) const override {
    if (IsInPlane(from, center_, n_, size_)) return {};
    if (IsFar(from, center_, size_)) {
      return SampleByArea(from, PointAt(SampleTriangle(u)), n_, area_);
    }
    const SphericalTriangle seen = SeenFrom(from);
    if (!(seen.SolidAngle() > kLeastAngle)) return {};
    // Where the direction meets the plane.
    const Vec3d w = seen.Sample(u), n = ToDouble(n_);
    const double t = Dot(n, ToDouble(a_) - ToDouble(from)) / Dot(n, w);
    SurfaceSample sample = SampleByArea(from, ToFloat(ToDouble(from) + w * t), n_, area_);
    if (sample.pdf > 0) sample.pdf = static_cast<float>(seen.Pdf());
    return sample;
  }

  float Pdf(Vec3 from, Vec3 p, Vec3) const override {
    if (IsInPlane(from, center_, n_, size_)) return 0;
    if (IsFar(from, center_, size_)) return PdfByArea(from, p, n_, area_);
    const SphericalTriangle seen = SeenFrom(from);
    return seen.SolidAngle() > kLeastAngle ? static_cast<float>(seen.Pdf()) : 0;
  }

  AreaSample SampleArea(Vec2 u) const override {
    return SampleOfArea(PointAt(SampleTriangle(u)), n_, size_, PdfArea(n_));
  }

  double Area() const override { return area_; }
  Vec3 FlatNormal() const override { return n_; }
  uint64_t MemoryBytes() const override { return sizeof *this; }

 private:
  /// So little is seen edge-on, or of a sliver; rays find it.
  static constexpr double kLeastAngle = 1e-6;

  Vec3 PointAt(Vec2 weights) const { return TrianglePoint(a_, b_, c_, weights.x, weights.y); }
  SphericalTriangle SeenFrom(Vec3 from) const {
    const Vec3d origin = ToDouble(from);
    return {ToDouble(a_) - origin, ToDouble(b_) - origin, ToDouble(c_) - origin};
  }

  Vec3 a_, b_, c_, center_, n_;
  double area_;
  float size_;
};

}  // namespace

std::unique_ptr<const SurfaceSampler> Triangle::MakeSampler(
    const Transform& world_from_object, const Transform& object_from_world) const {
  return std::make_unique<TriangleSampler>(
      world_from_object.Point(corners_[0]), world_from_object.Point(corners_[1]),
      world_from_object.Point(corners_[2]),
      NormalizeAnyLength(object_from_world.TransposedVector(normal_)));
}

}  // namespace candela
