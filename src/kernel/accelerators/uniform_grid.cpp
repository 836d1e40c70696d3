#include "kernel/accelerators/uniform_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "kernel/accelerators/entry_search.h"
#include "kernel/build/fragment.h"

namespace candela::kernel {
namespace {

/// As many cells as a few times the entries: Cleary, Wyvill, Birtwistle and Vatti, "Multiprocessor
/// Ray Tracing", 1986.
constexpr uint64_t kCellsOfEntry = 4;
/// Lists are at most this many times as long as there are entries, whatever lies where.
constexpr uint64_t kMostListed = 32;
/// The margin around entries, as a part of a cell.
constexpr double kMarginOfCell = 1.0 / 16;
/// Rays that begin so many times as far away as anything in the grid walk through its cells.
constexpr double kUsualDistance = 16;

template <class Visit>
void ForEachCell(const int (&low)[3], const int (&high)[3], const Visit& visit) {
  for (int z = low[2]; z <= high[2]; ++z) {
    for (int y = low[1]; y <= high[1]; ++y) {
      for (int x = low[0]; x <= high[0]; ++x) visit(x, y, z);
    }
  }
}

double Largest(Vec3d v) {
  return std::max({v.x, v.y, v.z});
}

}  // namespace

UniformGrid::UniformGrid(EntryTable table, std::span<const Bounds3> boxes,
                         const CancelToken* cancel)
    : Accelerator(std::move(table)) {
  if (boxes.empty()) return;
  Bounds3 bounds;
  for (const Bounds3& box : boxes) bounds.Extend(box);
  const double farthest = Largest(ToDouble(Max(Abs(bounds.min), Abs(bounds.max))));
  usual_rounding_ = PreciseRay::RoundingOf(kUsualDistance * farthest);
  for (int longest = kMostCellsOfAxis; longest >= 1; longest = longest * 3 / 4) {
    StopWhenCancelled(cancel);
    PlaceCells(bounds, longest);
    if (longest == 1 || IsSmallEnough(boxes)) break;
  }
  FillCells(boxes, cancel);
}

void UniformGrid::PlaceCells(const Bounds3& bounds, int longest) {
  const Vec3d extent = ToDouble(bounds.max) - ToDouble(bounds.min);
  const double side = Largest(extent) / longest;
  margin_ = std::max(side * kMarginOfCell, usual_rounding_);
  for (int axis = 0; axis < 3; ++axis) {
    low_[axis] = static_cast<double>(bounds.min[axis]) - margin_;
    high_[axis] = static_cast<double>(bounds.max[axis]) + margin_;
    count_[axis] = side > 0 ? std::max(1, static_cast<int>(extent[axis] / side + 0.5)) : 1;
    size_[axis] = (high_[axis] - low_[axis]) / count_[axis];
  }
}

bool UniformGrid::IsSmallEnough(std::span<const Bounds3> boxes) const {
  if (CellCount() > kCellsOfEntry * boxes.size()) return false;
  // A margin that is large beside the cells would list everything everywhere.
  for (int axis = 0; axis < 3; ++axis) {
    if (count_[axis] > 1 && size_[axis] * 2 * kMarginOfCell < margin_) return false;
  }
  const uint64_t most =
      std::min<uint64_t>(kMostListed * boxes.size(), std::numeric_limits<uint32_t>::max());
  uint64_t listed = 0;
  for (const Bounds3& box : boxes) {
    const Cells cells = CellsOf(box);
    uint64_t reached = 1;
    for (int axis = 0; axis < 3; ++axis) {
      reached *= static_cast<uint64_t>(cells.high[axis] - cells.low[axis] + 1);
    }
    listed += reached;
    if (listed > most) return false;
  }
  return true;
}

// Counts first, so that the lists of all cells lie in one array, each at its place.
void UniformGrid::FillCells(std::span<const Bounds3> boxes, const CancelToken* cancel) {
  first_.assign(CellCount() + 1, 0);
  for (const Bounds3& box : boxes) {
    const Cells cells = CellsOf(box);
    ForEachCell(cells.low, cells.high,
                [&](int x, int y, int z) { ++first_[IndexOf(x, y, z) + 1]; });
  }
  for (size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
  listed_.resize(first_.back());
  std::vector<uint32_t> next(first_.begin(), first_.end() - 1);
  for (uint32_t i = 0; i < boxes.size(); ++i) {
    if (i % 4096 == 0) StopWhenCancelled(cancel);
    const Cells cells = CellsOf(boxes[i]);
    ForEachCell(cells.low, cells.high,
                [&](int x, int y, int z) { listed_[next[IndexOf(x, y, z)]++] = i; });
  }
}

UniformGrid::Cells UniformGrid::CellsOf(const Bounds3& box) const {
  Cells cells;
  for (int axis = 0; axis < 3; ++axis) {
    cells.low[axis] = CellAt(static_cast<double>(box.min[axis]) - margin_, axis);
    cells.high[axis] = CellAt(static_cast<double>(box.max[axis]) + margin_, axis);
  }
  return cells;
}

int UniformGrid::CellAt(double coordinate, int axis) const {
  const double cell = (coordinate - low_[axis]) / size_[axis];
  return static_cast<int>(std::clamp(cell, 0.0, static_cast<double>(count_[axis] - 1)));
}

size_t UniformGrid::CellCount() const {
  return static_cast<size_t>(count_[0]) * static_cast<size_t>(count_[1]) *
         static_cast<size_t>(count_[2]);
}

size_t UniformGrid::IndexOf(int x, int y, int z) const {
  return static_cast<size_t>(x) +
         static_cast<size_t>(count_[0]) *
             (static_cast<size_t>(y) + static_cast<size_t>(count_[1]) * static_cast<size_t>(z));
}

bool UniformGrid::Walk(EntrySearch* search) const {
  if (listed_.empty()) return false;
  const PreciseRay ray = search->CurrentRay();
  const bool trusts_cells = ray.rounding <= margin_;
  const Vec3d around = Vec3d{1, 1, 1} * (trusts_cells ? 0 : ray.rounding);
  const double enter = ray.Enter(low_ - around, high_ + around);
  if (enter > search->NearestT()) return false;
  return trusts_cells ? WalkCells(ray, enter, search) : TestAll(search);
}

bool UniformGrid::WalkCells(const PreciseRay& ray, double enter, EntrySearch* search) const {
  int cell[3], step[3];
  double next[3];    // Where the ray enters the next cell along each axis,
  double stride[3];  // and from one to the one after that.
  for (int axis = 0; axis < 3; ++axis) {
    const double d = ray.direction[axis];
    cell[axis] = CellAt(ray.origin[axis] + d * enter, axis);
    step[axis] = d > 0 ? 1 : -1;
    stride[axis] = d == 0 ? 0 : size_[axis] / std::abs(d);
    const double wall = low_[axis] + size_[axis] * (cell[axis] + (d > 0 ? 1 : 0));
    next[axis] = d == 0 ? std::numeric_limits<double>::infinity() : (wall - ray.origin[axis]) / d;
  }
  Mailbox tested;
  while (enter <= search->NearestT()) {
    const size_t index = IndexOf(cell[0], cell[1], cell[2]);
    for (uint32_t i = first_[index]; i < first_[index + 1]; ++i) {
      const uint32_t entry = listed_[i];
      if (tested.IsNew(entry) && search->Test(table().entries[entry])) return true;
    }
    const int axis =
        next[0] <= next[1] ? (next[0] <= next[2] ? 0 : 2) : (next[1] <= next[2] ? 1 : 2);
    cell[axis] += step[axis];
    if (cell[axis] < 0 || cell[axis] >= count_[axis]) return false;
    enter = next[axis];
    next[axis] += stride[axis];
  }
  return false;
}

bool UniformGrid::TestAll(EntrySearch* search) const {
  for (const Entry& entry : table().entries) {
    if (search->Test(entry)) return true;
  }
  return false;
}

uint64_t UniformGrid::MemoryBytes() const {
  return Accelerator::MemoryBytes() + (first_.capacity() + listed_.capacity()) * sizeof(uint32_t);
}

}  // namespace candela::kernel
