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
/// axis of space that is nearest to Newell's normal. Takes about n * sqrt(n) steps for n corners.
/// Keeps its memory from one polygon to the next; one per thread.
class PolygonCutter {
 public:
  using Triangle = std::array<uint32_t, 3>;

  /// Corner numbers of the triangles, which turn as the polygon does; valid until the next call.
  /// Collinear corners become corners of triangles too; repeated corners and spikes may be left
  /// out. A polygon that crosses itself, or whose net area is zero, has no right answer: what ear
  /// clipping leaves of it becomes a fan, in which triangles may lack area or turn the other way.
  std::span<const Triangle> Cut(std::span<const Vec3> corners);

 private:
  bool Project(std::span<const Vec3> corners);
  bool IsFan() const;
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
