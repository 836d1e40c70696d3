#include <algorithm>

#include "sampling/spherical_rectangle.h"
#include "shapes/rectangle.h"
#include "shapes/surface_sampler.h"

namespace candela {
namespace {

/// By solid angle. By area from afar, and where the transform has made a parallelogram of the
/// rectangle.
class RectangleSampler final : public SurfaceSampler {
 public:
  RectangleSampler(Vec3 corner, Vec3 side_x, Vec3 side_y, Vec3 n)
      : corner_(ToDouble(corner)),
        side_x_(ToDouble(side_x)),
        side_y_(ToDouble(side_y)),
        seen_(corner_, side_x_, side_y_),
        center_(corner + side_x * 0.5f + side_y * 0.5f),
        n_(n) {
    area_ = Length(Cross(side_x_, side_y_));
    size_ = static_cast<float>(std::max(Length(side_x_), Length(side_y_)));
  }

  SurfaceSample Sample(Vec3 from, Vec2 u) const override {
    if (IsInPlane(from, center_, n_, size_)) return {};
    if (IsByArea(from)) return SampleByArea(from, PointAt(u), n_, area_);
    const SphericalRectangle seen = seen_.From(ToDouble(from));
    if (!(seen.SolidAngle() > kLeastAngle)) return {};
    SurfaceSample sample = SampleByArea(from, PointAt(seen.Sample(u)), n_, area_);
    if (sample.pdf > 0) sample.pdf = static_cast<float>(seen.Pdf());
    return sample;
  }

  float Pdf(Vec3 from, Vec3 p, Vec3) const override {
    if (IsInPlane(from, center_, n_, size_)) return 0;
    if (IsByArea(from)) return PdfByArea(from, p, n_, area_);
    const SphericalRectangle seen = seen_.From(ToDouble(from));
    return seen.SolidAngle() > kLeastAngle ? static_cast<float>(seen.Pdf()) : 0;
  }

  AreaSample SampleArea(Vec2 u) const override {
    return SampleOfArea(PointAt(u), n_, size_, PdfArea(n_));
  }

  double Area() const override { return area_; }
  Vec3 FlatNormal() const override { return n_; }
  uint64_t MemoryBytes() const override { return sizeof *this; }

 private:
  /// So little is seen edge-on, or of a long and narrow one; rays find it.
  static constexpr double kLeastAngle = 1e-6;

  bool IsByArea(Vec3 from) const { return !seen_.IsRightAngled() || IsFar(from, center_, size_); }
  Vec3 PointAt(Vec2 place) const {
    return ToFloat(corner_ + side_x_ * double{place.x} + side_y_ * double{place.y});
  }

  Vec3d corner_, side_x_, side_y_;
  SeenRectangle seen_;
  Vec3 center_, n_;
  double area_;
  float size_;
};

}  // namespace

std::unique_ptr<const SurfaceSampler> Rectangle::MakeSampler(
    const Transform& world_from_object, const Transform& object_from_world) const {
  return std::make_unique<RectangleSampler>(
      world_from_object.Point({-half_width_, -half_height_, 0}),
      world_from_object.Vector({2 * half_width_, 0, 0}),
      world_from_object.Vector({0, 2 * half_height_, 0}),
      NormalizeAnyLength(object_from_world.TransposedVector({0, 0, 1})));
}

}  // namespace candela
