#include <algorithm>
#include <cmath>

#include "math/frame.h"
#include "sampling/warp.h"
#include "shapes/sphere.h"
#include "shapes/surface_sampler.h"

namespace candela {
namespace {

/// Draws directions evenly from the cone in which the sphere is seen, in object space; what a
/// transform does to densities over solid angle is |det M| / |M w|^3, so this holds for ellipsoids
/// too, though their directions are not drawn as evenly.
class SphereSampler final : public SurfaceSampler {
 public:
  SphereSampler(float radius, const Transform& world_from_object,
                const Transform& object_from_world)
      : radius_(radius),
        world_from_object_(world_from_object),
        object_from_world_(object_from_world) {
    const Vec3d x = ToDouble(world_from_object.Vector({1, 0, 0}));
    const Vec3d y = ToDouble(world_from_object.Vector({0, 1, 0}));
    const Vec3d z = ToDouble(world_from_object.Vector({0, 0, 1}));
    determinant_ = std::abs(Dot(x, Cross(y, z)));
    area_ = EllipsoidArea(Length(Cross(x, y)), Length(Cross(y, z)), Length(Cross(z, x)));
  }

  SurfaceSample Sample(Vec3 from, Vec2 u) const override {
    const Vec3d origin = ToDouble(object_from_world_.Point(from));
    const double squared = LengthSquared(origin);
    if (IsInside(squared)) return {};
    const double distance = std::sqrt(squared);
    const float one_minus_cosine = OneMinusCosine(squared);
    const Frame frame = Frame::FromNormal(ToFloat(origin * (-1 / distance)));
    const Vec3 w = frame.ToWorld(SampleCone(u, one_minus_cosine));

    // The near one of the points where the ray meets the sphere. The sine comes from the number
    // that the direction was made of: at the rim the direction itself has lost it.
    const double below = double{u.x} * double{one_minus_cosine};
    const double sine2 = below * (2 - below);
    const double r2 = double{radius_} * radius_;
    const double t = distance * (1 - below) - std::sqrt(std::max(0.0, r2 - squared * sine2));
    const Vec3 normal = NormalizeAnyLength(ToFloat(origin + ToDouble(w) * t));
    const Vec3 p = world_from_object_.Point(normal * radius_);
    const Vec3 n = NormalizeAnyLength(object_from_world_.TransposedVector(normal));
    SurfaceSample sample = SampleByArea(from, p, n, area_);
    if (!(sample.distance > 0)) return {};
    sample.pdf = PdfInWorld(w, one_minus_cosine);
    return sample;
  }

  float Pdf(Vec3 from, Vec3 p, Vec3) const override {
    const double squared = LengthSquared(ToDouble(object_from_world_.Point(from)));
    if (IsInside(squared)) return 0;
    return PdfInWorld(Normalize(object_from_world_.Vector(p - from)), OneMinusCosine(squared));
  }

  AreaSample SampleArea(Vec2 u) const override {
    const Vec3 normal = SampleUniformSphere(u);
    const Vec3 p = world_from_object_.Point(normal * radius_);
    const Vec3 n = NormalizeAnyLength(object_from_world_.TransposedVector(normal));
    return SampleOfArea(p, n, static_cast<float>(std::sqrt(area_)), PdfArea(n));
  }

  // Points are drawn evenly in object space. With the normals n of the world, M stretches areas by
  // |det M| / |transposed M n|.
  float PdfArea(Vec3 n) const override {
    const double length = Length(ToDouble(world_from_object_.TransposedVector(n)));
    return static_cast<float>(length / (determinant_ * 4 * kPi * double{radius_} * radius_));
  }

  double Area() const override { return area_; }
  uint64_t MemoryBytes() const override { return sizeof *this; }

 private:
  /// Inside, and on the sphere itself, the whole of it is seen, or half of all directions: rays
  /// that are drawn for the surface at `from` are as good.
  bool IsInside(double squared) const {
    return !(squared > double{radius_} * radius_ * (1 + 1e-4));
  }

  float OneMinusCosine(double squared) const {
    const double sine2 = double{radius_} * radius_ / squared;
    return static_cast<float>(sine2 / (1 + std::sqrt(1 - sine2)));
  }

  /// `w` is the unit direction in object space.
  float PdfInWorld(Vec3 w, float one_minus_cosine) const {
    const double length = Length(ToDouble(world_from_object_.Vector(w)));
    return static_cast<float>(double{ConePdf(one_minus_cosine)} * length * length * length /
                              determinant_);
  }

  /// From the areas that the axes span in pairs, by K. Thomsen's formula (2004): exact for spheres,
  /// within 1.1 percent for others.
  double EllipsoidArea(double xy, double yz, double zx) const {
    constexpr double kPower = 1.6075;
    const double mean = (Pow(xy, kPower) + Pow(yz, kPower) + Pow(zx, kPower)) / 3;
    return 4 * kPi * double{radius_} * radius_ * Pow(mean, 1 / kPower);
  }

  float radius_;
  Transform world_from_object_, object_from_world_;
  double determinant_;
  double area_;
};

}  // namespace

std::unique_ptr<const SurfaceSampler> Sphere::MakeSampler(
    const Transform& world_from_object, const Transform& object_from_world) const {
  return std::make_unique<SphereSampler>(radius_, world_from_object, object_from_world);
}

}  // namespace candela
