#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "loaders/obj/point_tree.h"
#include "math/vec.h"

namespace candela {

/// Cuts polygons into triangles. Convex ones become a fan from the first corner, others are cut by
/// ear clipping [Meisters 1975; O'Rourke, Computational Geometry in C, section 1.6], seen along the
/// axis of space that is nearest to Newell's normal. About n * sqrt(n) steps for n corners, and no
/// input takes more than a few times that. Keeps its memory from one polygon to the next; one per
/// thread.
class PolygonCutter {
 public:
  using Triangle = std::array<uint32_t, 3>;

  /// Corner numbers of the triangles, turning as the polygon does; valid until the next call. No
  /// corners are added; triangles without area may be among them (a fan over collinear corners).
  /// Repeated corners and spikes are legal. A polygon that crosses itself, or whose net area is
  /// zero, has no right answer: what ear clipping leaves of it becomes a fan.
  std::span<const Triangle> Cut(std::span<const Vec3> corners);

 private:
  bool Project(std::span<const Vec3> corners);
  bool IsConvex() const;
  void ClipEars();
  bool IsSpike(uint32_t corner) const;
  bool IsEar(uint32_t corner) const;
  void Remove(uint32_t corner);
  void Fan(uint32_t first, uint32_t count);

  std::vector<Vec2> points_;               ///< The corners, counter-clockwise.
  std::vector<uint32_t> next_, previous_;  ///< The ring of corners that are left.
  std::vector<uint32_t> queue_;            ///< Corners that may have become ears.
  std::vector<uint32_t> hollow_;
  PointTree hollow_tree_;  ///< Corners of 180 degrees and more: only they can lie in ears.
  std::vector<Triangle> triangles_;
};

}  // namespace candela
