#include "loaders/obj/polygon_cutter.h"

#include <limits>
#include <utility>

namespace candela {
namespace {

constexpr uint32_t kGone = std::numeric_limits<uint32_t>::max();

/// True when the way from `a` over `b` to `c` does not go on at `b`: it stays or turns back there.
bool TurnsBack(Vec2 a, Vec2 b, Vec2 c) {
  const double forward =
      (double{b.x} - a.x) * (double{c.x} - b.x) + (double{b.y} - a.y) * (double{c.y} - b.y);
  return Orient(a, b, c) == 0 && forward <= 0;
}

}  // namespace

std::span<const PolygonCutter::Triangle> PolygonCutter::Cut(std::span<const Vec3> corners) {
  const auto count = static_cast<uint32_t>(corners.size());
  triangles_.clear();
  if (count < 3) return triangles_;

  next_.resize(count);
  previous_.resize(count);
  for (uint32_t i = 0; i < count; ++i) {
    next_[i] = i + 1 == count ? 0 : i + 1;
    previous_[i] = i == 0 ? count - 1 : i - 1;
  }
  if (!Project(corners) || IsFan()) {
    Fan(0, count);
  } else {
    ClipEars();
  }
  return triangles_;
}

/// Fills `points_`; false when the polygon has no net area, so that no plane is its own.
bool PolygonCutter::Project(std::span<const Vec3> corners) {
  // Newell's normal, twice the area of the polygon in length, as a sum over the fan from corner 0.
  Vec3d normal;
  const Vec3d origin = ToDouble(corners[0]);
  for (size_t i = 2; i < corners.size(); ++i) {
    normal += Cross(ToDouble(corners[i - 1]) - origin, ToDouble(corners[i]) - origin);
  }
  if (normal == Vec3d{}) return false;

  // Dropping a coordinate keeps the others exact, and convexity and sides as they are in the plane.
  const int axis = LargestAxis(normal);
  int u = (axis + 1) % 3, v = (axis + 2) % 3;
  if (normal[axis] < 0) std::swap(u, v);
  points_.clear();
  for (const Vec3 corner : corners) points_.push_back({corner[u], corner[v]});
  return true;
}

/// True for convex polygons, unless collinear corners beside the first one would give its fan a
/// triangle without area.
bool PolygonCutter::IsFan() const {
  for (uint32_t b = 0; b < points_.size(); ++b) {
    const uint32_t a = previous_[b], c = next_[b];
    if (Orient(points_[a], points_[b], points_[c]) < 0) return false;
    const bool is_in_fan = b != 0 && c != 0;
    if (is_in_fan && Orient(points_[0], points_[b], points_[c]) <= 0) return false;
  }
  return true;
}

void PolygonCutter::ClipEars() {
  const auto count = static_cast<uint32_t>(points_.size());
  hollow_.clear();
  queue_.clear();
  for (uint32_t i = 0; i < count; ++i) {
    queue_.push_back(i);
    if (Orient(points_[previous_[i]], points_[i], points_[next_[i]]) <= 0) hollow_.push_back(i);
  }
  hollow_tree_.Build(points_, hollow_);

  // Cutting an ear only takes from the polygon, so a corner that is no ear can become one only when
  // a neighbour goes: each cut adds two corners to look at, three times `count` in all.
  uint32_t left = count;
  uint32_t last = 0;
  for (size_t i = 0; i < queue_.size() && left > 3; ++i) {
    const uint32_t corner = queue_[i];
    if (next_[corner] == kGone) continue;
    const bool is_spike = IsSpike(corner);
    if (!is_spike && !IsEar(corner)) continue;
    if (!is_spike) triangles_.push_back({previous_[corner], corner, next_[corner]});
    last = next_[corner];
    Remove(corner);
    --left;
  }
  Fan(last, left);
}

bool PolygonCutter::IsSpike(uint32_t corner) const {
  return TurnsBack(points_[previous_[corner]], points_[corner], points_[next_[corner]]);
}

bool PolygonCutter::IsEar(uint32_t corner) const {
  const Vec2 a = points_[previous_[corner]], b = points_[corner], c = points_[next_[corner]];
  return Orient(a, b, c) > 0 && !hollow_tree_.HasPointIn(a, b, c);
}

void PolygonCutter::Remove(uint32_t corner) {
  const uint32_t before = previous_[corner], after = next_[corner];
  next_[before] = after;
  previous_[after] = before;
  next_[corner] = kGone;
  hollow_tree_.Remove(corner);
  for (const uint32_t changed : {before, after}) {
    queue_.push_back(changed);
    if (Orient(points_[previous_[changed]], points_[changed], points_[next_[changed]]) > 0) {
      hollow_tree_.Remove(changed);
    }
  }
}

/// The ring's `count` corners as a fan around `first`.
void PolygonCutter::Fan(uint32_t first, uint32_t count) {
  uint32_t b = next_[first];
  for (uint32_t i = 2; i < count; ++i, b = next_[b]) triangles_.push_back({first, b, next_[b]});
}

}  // namespace candela
