#include <algorithm>
#include <cmath>

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
        center_(corner + side_x * 0.5f + side_y * 0.5f),
        n_(n) {
    width_ = Length(side_x_);
    height_ = Length(side_y_);
    along_x_ = Normalize(side_x_);
    along_y_ = Normalize(side_y_);
    along_n_ = Cross(along_x_, along_y_);
    area_ = Length(Cross(side_x_, side_y_));
    size_ = static_cast<float>(std::max(width_, height_));
    is_right_angled_ = std::abs(Dot(along_x_, along_y_)) <= 1e-6;
  }

  SurfaceSample Sample(Vec3 from, Vec2 u) const override {
    if (IsInPlane(from, center_, n_, size_)) return {};
    if (IsByArea(from)) return SampleByArea(from, PointAt(u), n_, area_);
    const SphericalRectangle seen = SeenFrom(from);
    if (!(seen.SolidAngle() > kLeastAngle)) return {};
    SurfaceSample sample = SampleByArea(from, PointAt(seen.Sample(u)), n_, area_);
    if (sample.pdf > 0) sample.pdf = static_cast<float>(seen.Pdf());
    return sample;
  }

  float Pdf(Vec3 from, Vec3 p, Vec3) const override {
    if (IsInPlane(from, center_, n_, size_)) return 0;
    if (IsByArea(from)) return PdfByArea(from, p, n_, area_);
    const SphericalRectangle seen = SeenFrom(from);
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

  bool IsByArea(Vec3 from) const { return !is_right_angled_ || IsFar(from, center_, size_); }
  SphericalRectangle SeenFrom(Vec3 from) const {
    const Vec3d way = corner_ - ToDouble(from);
    return {Vec3d{Dot(way, along_x_), Dot(way, along_y_), Dot(way, along_n_)}, width_, height_};
  }
  Vec3 PointAt(Vec2 place) const {
    return ToFloat(corner_ + side_x_ * double{place.x} + side_y_ * double{place.y});
  }

  Vec3d corner_, side_x_, side_y_;
  Vec3d along_x_, along_y_, along_n_;  ///< The unit axes of coordinates in the plane.
  double width_, height_, area_;
  Vec3 center_, n_;
  float size_;
  bool is_right_angled_;
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
