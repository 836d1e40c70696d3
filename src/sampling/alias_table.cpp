#include "sampling/alias_table.h"

#include <algorithm>

#include "base/check.h"

namespace candela {

AliasTable::AliasTable(std::span<const double> weights) : slots_(weights.size()) {
  double sum = 0;
  for (const double weight : weights) sum += weight;
  CHECK(sum > 0);
  // Weights in units of the mean: a slot holds 1. What has less is filled up by what has more.
  const double scale = static_cast<double>(weights.size()) / sum;
  std::vector<double> left(weights.size());
  std::vector<uint32_t> small, large;
  for (uint32_t i = 0; i < weights.size(); ++i) {
    left[i] = weights[i] * scale;
    (left[i] < 1 ? small : large).push_back(i);
  }
  while (!small.empty() && !large.empty()) {
    const uint32_t filled = small.back(), giver = large.back();
    small.pop_back();
    slots_[filled] = {static_cast<float>(left[filled]), giver};
    left[giver] -= 1 - left[filled];
    if (left[giver] < 1) {
      large.pop_back();
      small.push_back(giver);
    }
  }
  // What remains is 1 up to rounding. A weight of 0 is never among it: it would be among the first
  // to be filled, unless rounding has used up all that was large.
  for (const auto* rest : {&small, &large}) {
    for (const uint32_t i : *rest) slots_[i] = {1, i};
  }
  uint32_t heaviest = 0;
  for (uint32_t i = 1; i < weights.size(); ++i) {
    if (weights[i] > weights[heaviest]) heaviest = i;
  }
  for (uint32_t i = 0; i < weights.size(); ++i) {
    if (weights[i] == 0 && slots_[i].alias == i) slots_[i].alias = heaviest;
    if (weights[i] == 0) slots_[i].keep = 0;
  }
}

AliasTable::Choice AliasTable::Draw(double u) const {
  constexpr double kLast = 0x1.fffffffffffffp-1;
  const double scaled = u * static_cast<double>(slots_.size());
  const uint32_t slot =
      std::min(static_cast<uint32_t>(scaled), static_cast<uint32_t>(slots_.size() - 1));
  const double within = std::min(scaled - slot, kLast);
  const auto& [keep, alias] = slots_[slot];
  if (within < keep) return {slot, std::min(within / keep, kLast)};
  return {alias, std::min((within - keep) / (1 - keep), kLast)};
}

}  // namespace candela
