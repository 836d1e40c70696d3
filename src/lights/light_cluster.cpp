#include "lights/light_cluster.h"

#include <algorithm>
#include <cmath>

#include "math/elementary.h"

namespace candela {
namespace {

double AngleBetween(Vec3d a, Vec3d b) {
  return Acos(std::clamp(Dot(a, b), -1.0, 1.0));
}

/// Of the cone within `spread` of `a` and one within `other_spread` of `b`, the least around both.
/// The axis of a is turned in the plane of both until it is in the middle.
void MergeCones(Vec3d b, double other_spread, Vec3d* a, double* spread) {
  const double between = AngleBetween(*a, b);
  if (between + other_spread <= *spread) return;
  if (between + *spread <= other_spread) {
    *a = b;
    *spread = other_spread;
    return;
  }
  const double merged = (*spread + between + other_spread) / 2;
  const Vec3d across = b - *a * Dot(*a, b);
  const double length = std::sqrt(Dot(across, across));
  if (merged >= kPi || !(length > 1e-9)) {
    *spread = kPi;  // Or no plane is the right one.
    return;
  }
  const double turn = merged - *spread;
  *a = *a * Cos(turn) + across * (Sin(turn) / length);
  *a = *a / std::sqrt(Dot(*a, *a));
  *spread = merged;
}

}  // namespace

LightCluster LightCluster::Of(const LightReach& reach) {
  LightCluster cluster;
  const Vec3 radius{reach.radius, reach.radius, reach.radius};
  cluster.box = {reach.center - radius, reach.center + radius};
  cluster.power = double{reach.power};
  cluster.is_flat = reach.is_flat;
  cluster.is_two_sided = reach.is_flat && reach.least_cosine < 0;
  if (reach.axis == Vec3()) {
    cluster.spread = cluster.cone = kPi;
    return cluster;
  }
  cluster.axis = ToDouble(reach.axis);
  // A flat light shines to the right angle, on one side or on both.
  cluster.cone = reach.is_flat ? kPi / 2 : Acos(std::clamp(double{reach.least_cosine}, -1.0, 1.0));
  return cluster;
}

void LightCluster::Add(const LightCluster& other) {
  if (box.IsEmpty()) {
    *this = other;
    return;
  }
  box.Extend(other.box);
  power += other.power;
  cone = std::max(cone, other.cone);
  is_flat = is_flat && other.is_flat;
  AddAxis(other);
}

void LightCluster::AddAxis(const LightCluster& other) {
  if (axis == Vec3d() || other.axis == Vec3d()) {
    axis = {};
    spread = cone = kPi;
    is_flat = is_two_sided = false;
    return;
  }
  // One that shines both ways has its axis as the others like it. Beside one that does not it is
  // taken as two that shine one way each.
  const bool both = is_two_sided && other.is_two_sided;
  const bool is_opposite = Dot(axis, other.axis) < 0;
  if (both) {
    MergeCones(is_opposite ? -other.axis : other.axis, other.spread, &axis, &spread);
    return;
  }
  MergeCones(other.axis, other.spread, &axis, &spread);
  if (is_two_sided || other.is_two_sided) spread = kPi;
  is_two_sided = false;
}

double LightCluster::Cost() const {
  if (box.IsEmpty()) return 0;
  // The square of the diagonal takes the place of the area, which lights in a row do not have.
  const Vec3d extent = ToDouble(box.max) - ToDouble(box.min);
  // The solid angle of the axes, and around it, weighed with the cosine, that of the cones.
  const double far = std::min(spread + cone, kPi);
  const double solid =
      2 * kPi * (1 - Cos(spread)) +
      kPi / 2 *
          (2 * far * Sin(spread) - Cos(spread - 2 * far) - 2 * spread * Sin(spread) + Cos(spread));
  return power * Dot(extent, extent) * solid;
}

}  // namespace candela
