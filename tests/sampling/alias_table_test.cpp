#include "sampling/alias_table.h"

#include <gtest/gtest.h>

#include <vector>

#include "tests/sampling/chi_square.h"

namespace candela {
namespace {

using test::ChiSquareDeviate;
using test::kLargestDeviate;
using test::UniformNumbers;

// P1
TEST(AliasTable, DrawsEachAsOftenAsItsWeightSays) {
  UniformNumbers numbers(1);
  std::vector<double> weights(300);
  for (size_t i = 0; i < weights.size(); ++i) {
    const double x = static_cast<double>(numbers.Next());
    weights[i] = i % 10 == 3 ? 0 : x * x * x + 0.001;
  }
  const AliasTable table(weights);
  std::vector<uint64_t> counts(weights.size());
  for (int i = 0; i < 1000000; ++i) ++counts[table.Draw(static_cast<double>(numbers.Next())).index];
  double sum = 0;
  for (const double weight : weights) sum += weight;
  for (double& weight : weights) weight /= sum;
  EXPECT_LT(ChiSquareDeviate(counts, weights), kLargestDeviate);
}

// Of each thing's part of [0, 1) the rest runs evenly from 0 to 1.
TEST(AliasTable, WhatIsLeftOfTheNumberIsEvenlySpread) {
  const std::vector<double> weights = {1, 5, 0.5, 2};
  const AliasTable table(weights);
  std::vector<uint64_t> counts(weights.size() * 16);
  constexpr int kSteps = 1 << 20;
  for (int i = 0; i < kSteps; ++i) {
    const auto [index, rest] = table.Draw((i + 0.5) / kSteps);
    ASSERT_TRUE(rest >= 0 && rest < 1);
    ++counts[index * 16 + static_cast<size_t>(rest * 16)];
  }
  for (size_t i = 0; i < counts.size(); ++i) {
    EXPECT_NEAR(static_cast<double>(counts[i]), kSteps * weights[i / 16] / 8.5 / 16, 8);
  }
}

TEST(AliasTable, NeverDrawsAWeightOfZero) {
  const AliasTable table(std::vector<double>{0, 1e-30, 0, 3e-30, 0});
  for (int i = 0; i < 1000; ++i) EXPECT_EQ(table.Draw(i / 1000.0).index % 2, 1u);
}

TEST(AliasTable, OfOneThingLeavesTheNumberAsItIs) {
  const auto [index, rest] = AliasTable(std::vector<double>{7}).Draw(0.375);
  EXPECT_EQ(index, 0u);
  EXPECT_EQ(rest, 0.375);
}

}  // namespace
}  // namespace candela
