#pragma once

#include <span>
#include <vector>

#include "geometry/bounds3.h"
#include "kernel/accelerators/accelerator.h"
#include "kernel/accelerators/precise_ray.h"

namespace candela::kernel {

/// A box that is cut into equal cells, each with a list of what reaches into it. A ray walks from
/// cell to cell by a three-dimensional differential analyser: Amanatides and Woo, "A Fast Voxel
/// Traversal Algorithm for Ray Tracing", 1987.
class UniformGrid final : public Accelerator {
 public:
  UniformGrid(EntryTable table, std::span<const Bounds3> boxes, const CancelToken* cancel);

  bool Walk(EntrySearch* search) const override;
  uint64_t MemoryBytes() const override;

  /// Cells along an axis.
  int CellCount(int axis) const { return count_[axis]; }
  static constexpr int kMostCellsOfAxis = 256;

 private:
  struct Cells {
    int low[3], high[3];  ///< Both included.
  };

  /// Places the cells so that there are `longest` of them along the longest axis.
  void PlaceCells(const Bounds3& bounds, int longest);
  /// Whether there are so few cells, which list so few entries, that it is worth it.
  bool IsSmallEnough(std::span<const Bounds3> boxes) const;
  void FillCells(std::span<const Bounds3> boxes, const CancelToken* cancel);

  Cells CellsOf(const Bounds3& box) const;
  int CellAt(double coordinate, int axis) const;
  size_t CellCount() const;
  size_t IndexOf(int x, int y, int z) const;
  bool WalkCells(const PreciseRay& ray, double enter, EntrySearch* search) const;
  bool TestAll(EntrySearch* search) const;

  Vec3d low_, high_;  ///< Of the grid.
  Vec3d size_;        ///< Of a cell.
  int count_[3] = {0, 0, 0};
  /// Entries are listed in the cells that they come so close to. Rays whose rounding is larger
  /// cannot trust the cells.
  double margin_ = 0;
  double usual_rounding_ = 0;     ///< Of rays that begin not very far from the grid.
  std::vector<uint32_t> first_;   ///< Of each cell, where its list begins; and the end.
  std::vector<uint32_t> listed_;  ///< Indices of entries, cell after cell.
};

}  // namespace candela::kernel
