#include <algorithm>

#include "sampling/spherical_rectangle.h"
#include "sampling/warp.h"
#include "shapes/disk.h"
#include "shapes/surface_sampler.h"

namespace candela {
namespace {

/// From near, by the solid angle of the square around the disk: the share pi/4 of it meets the
/// disk, and no direction weighs more than another, however near. From afar, where such directions
/// would be wasted, and where the transform has slanted the square, by area.
class DiskSampler final : public SurfaceSampler {
 public:
  /// The radii are those along x and y.
  DiskSampler(Vec3 center, Vec3 radius_x, Vec3 radius_y, Vec3 n)
      : center_(ToDouble(center)),
        radius_x_(ToDouble(radius_x)),
        radius_y_(ToDouble(radius_y)),
        square_(center_ - radius_x_ - radius_y_, radius_x_ * 2.0, radius_y_ * 2.0),
        n_(n) {
    area_ = kPi * Length(Cross(radius_x_, radius_y_));
    size_ = std::max(Length(radius_x), Length(radius_y));
  }

  SurfaceSample Sample(Vec3 from, Vec2 u) const override {
    if (IsInPlane(from, ToFloat(center_), n_, size_)) return {};
    if (!IsNear(from)) return SampleByArea(from, PointAt(SampleDisk(u)), n_, area_);
    const SphericalRectangle seen = square_.From(ToDouble(from));
    if (!(seen.SolidAngle() > kLeastAngle)) return {};
    const Vec2 place = seen.Sample(u);
    const Vec2 on_disk{2 * place.x - 1, 2 * place.y - 1};
    if (on_disk.x * on_disk.x + on_disk.y * on_disk.y > 1) return {};  // In a corner.
    SurfaceSample sample = SampleByArea(from, PointAt(on_disk), n_, area_);
    if (sample.pdf > 0) sample.pdf = static_cast<float>(seen.Pdf());
    return sample;
  }

  float Pdf(Vec3 from, Vec3 p, Vec3) const override {
    if (IsInPlane(from, ToFloat(center_), n_, size_)) return 0;
    if (!IsNear(from)) return PdfByArea(from, p, n_, area_);
    const SphericalRectangle seen = square_.From(ToDouble(from));
    return seen.SolidAngle() > kLeastAngle ? static_cast<float>(seen.Pdf()) : 0;
  }

  AreaSample SampleArea(Vec2 u) const override {
    return SampleOfArea(PointAt(SampleDisk(u)), n_, size_, PdfArea(n_));
  }

  double Area() const override { return area_; }
  Vec3 FlatNormal() const override { return n_; }
  uint64_t MemoryBytes() const override { return sizeof *this; }

 private:
  /// So little is seen edge-on; rays find it.
  static constexpr double kLeastAngle = 1e-6;

  bool IsNear(Vec3 from) const {
    return square_.IsRightAngled() && !IsFar(from, ToFloat(center_), size_);
  }
  Vec3 PointAt(Vec2 place) const {
    return ToFloat(center_ + radius_x_ * double{place.x} + radius_y_ * double{place.y});
  }

  Vec3d center_, radius_x_, radius_y_;
  SeenRectangle square_;
  Vec3 n_;
  double area_;
  float size_;
};

}  // namespace

std::unique_ptr<const SurfaceSampler> Disk::MakeSampler(const Transform& world_from_object,
                                                        const Transform& object_from_world) const {
  return std::make_unique<DiskSampler>(
      world_from_object.Point({0, 0, 0}), world_from_object.Vector({radius_, 0, 0}),
      world_from_object.Vector({0, radius_, 0}),
      NormalizeAnyLength(object_from_world.TransposedVector({0, 0, 1})));
}

}  // namespace candela
