#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "math/vec.h"

namespace candela {

/// A density on [0, 1) that is constant on each of n equal intervals, drawn by inversion: near
/// numbers give near positions, so evenly spread numbers stay evenly spread. The same values give
/// the same bits everywhere, since sums are taken in the order of the intervals. Immutable.
class Distribution1D {
 public:
  /// Values are finite and not negative, at least one; if all are 0 the density is 1 everywhere.
  explicit Distribution1D(std::span<const float> values);

  struct Sample {
    float position;   ///< In [0, 1).
    float pdf;        ///< Over [0, 1); above 0.
    size_t interval;  ///< The one that holds the position.
  };
  /// `u` is in [0, 1).
  Sample Draw(float u) const;
  float Pdf(float position) const;
  /// The number in [0, 1] that `Draw` takes to the position.
  float Invert(float position) const;

  size_t size() const { return cumulative_.size() - 1; }
  uint64_t MemoryBytes() const { return cumulative_.capacity() * sizeof(float); }

 private:
  std::vector<float> cumulative_;  ///< From 0 to 1, one more than intervals.
};

/// A density on [0, 1)^2 that is constant on each cell of a grid: first the row is drawn, then the
/// place in it. Immutable.
class Distribution2D {
 public:
  /// `values` holds rows of `columns` cells each, y growing from row to row.
  Distribution2D(std::span<const float> values, size_t columns);

  struct Sample {
    Vec2 position;  ///< In [0, 1)^2.
    float pdf;      ///< Over [0, 1)^2; above 0.
  };
  Sample Draw(Vec2 u) const;
  float Pdf(Vec2 position) const;
  Vec2 Invert(Vec2 position) const;

  uint64_t MemoryBytes() const {
    return rows_.MemoryBytes() + cumulative_.capacity() * sizeof(float);
  }

 private:
  std::span<const float> Row(size_t row) const {
    return std::span(cumulative_).subspan(row * (columns_ + 1), columns_ + 1);
  }

  size_t columns_;
  std::vector<float> cumulative_;  ///< Of each row, one after the other.
  Distribution1D rows_;            ///< Chooses among them.
};

}  // namespace candela
