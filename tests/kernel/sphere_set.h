#pragma once

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "kernel/primitive_set.h"

namespace candela::test {

/// Spheres that move in straight lines between time steps; at rest with one step.
class SphereSet : public PrimitiveSet {
 public:
  struct Sphere {
    std::vector<Vec3> centers;  ///< One for each time step.
    float radius;
  };
  explicit SphereSet(std::vector<Sphere> spheres) : spheres_(std::move(spheres)) {}

  /// For groups that are refitted.
  void Replace(std::vector<Sphere> spheres) { spheres_ = std::move(spheres); }

  uint32_t PrimitiveCount() const override { return static_cast<uint32_t>(spheres_.size()); }
  uint32_t TimeSteps() const override {
    return spheres_.empty() ? 1 : static_cast<uint32_t>(spheres_[0].centers.size());
  }

  /// A little wider than the sphere: hits are rounded.
  Bounds3 PrimitiveBounds(uint32_t primitive, uint32_t step) const override {
    const Sphere& sphere = spheres_[primitive];
    const Vec3 center = sphere.centers[step];
    const Vec3 reach = Vec3{1, 1, 1} * (sphere.radius * 1.0001f) + Abs(center) * 1e-5f;
    return {center - reach, center + reach};
  }

  bool IntersectPrimitive(const Ray& ray, uint32_t primitive, HitRecord* hit) const override {
    const Sphere& sphere = spheres_[primitive];
    const Vec3d to_center = ToDouble(CenterAt(sphere, ray.time)) - ToDouble(ray.origin);
    const Vec3d direction = ToDouble(ray.direction);
    const double a = LengthSquared(direction), half_b = Dot(direction, to_center);
    const auto radius = static_cast<double>(sphere.radius);
    const Vec3d nearest = to_center - direction * (half_b / a);
    const double inside = radius * radius - LengthSquared(nearest);
    if (!(inside >= 0)) return false;
    for (const double side : {-1.0, 1.0}) {
      const auto t = static_cast<float>(half_b / a + side * std::sqrt(inside / a));
      if (!(t >= ray.t_min)) continue;
      if (!(t < hit->t)) return false;
      hit->t = t;
      hit->u = side < 0 ? 0.25f : 0.75f;
      hit->v = sphere.radius;
      return true;
    }
    return false;
  }

 private:
  static Vec3 CenterAt(const Sphere& sphere, float time) {
    const auto last = static_cast<uint32_t>(sphere.centers.size()) - 1;
    if (last == 0) return sphere.centers[0];
    const float position = time * static_cast<float>(last);
    const uint32_t step = std::min(static_cast<uint32_t>(position), last - 1);
    const float part = position - static_cast<float>(step);
    return sphere.centers[step] * (1 - part) + sphere.centers[step + 1] * part;
  }

  std::vector<Sphere> spheres_;
};

/// The half-space below a level: unbounded, met from above.
class GroundSet : public PrimitiveSet {
 public:
  explicit GroundSet(float level) : level_(level) {}
  Bounds3 PrimitiveBounds(uint32_t, uint32_t) const override { return Bounds3::Infinite(); }
  bool IntersectPrimitive(const Ray& ray, uint32_t, HitRecord* hit) const override {
    const float t = (level_ - ray.origin.y) / ray.direction.y;
    if (!(t >= ray.t_min && t < hit->t)) return false;
    hit->t = t;
    hit->u = hit->v = 0;
    return true;
  }

 private:
  float level_;
};

}  // namespace candela::test
