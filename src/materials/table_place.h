#pragma once

#include <algorithm>

namespace candela {

/// Between which two neighbours of a list a position lies: `index` and the one after it, of which
/// the latter counts by `part`. Positions beyond the ends are at these.
struct TablePlace {
  TablePlace(float position, int size)
      : index(std::clamp(static_cast<int>(position), 0, std::max(0, size - 2))),
        part(size > 1 ? std::clamp(position - static_cast<float>(index), 0.0f, 1.0f) : 0) {}

  /// What lies there, of the values of the two.
  template <class Value>
  Value Blend(const Value& a, const Value& b) const {
    return a * (1 - part) + b * part;
  }

  int index;
  float part;
};

}  // namespace candela
