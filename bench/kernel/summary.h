#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "results.h"

namespace candela {

/// One figure that the kernel is judged by.
struct SummaryRow {
  std::string_view name;
  double required = 0, goal = 0;
  bool less_is_better = false;
  /// Over the scenes that count and have the figure: the geometric mean, and the worst one.
  std::optional<double> mean;
  double worst = 0;
  std::string worst_scene;

  bool IsMet() const { return !mean || (less_is_better ? *mean <= required : *mean >= required); }
};

std::vector<SummaryRow> Summarize(const BenchResult& result);

}  // namespace candela
