#include "math/exact_sum.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace candela {
namespace {

ExactSum SumOf(const std::vector<float>& terms) {
  ExactSum sum;
  for (const float term : terms) sum.Add(term);
  return sum;
}

/// Terms of both signs and of all sizes from 1e-18 to 1e12.
std::vector<float> WildTerms(int count) {
  std::mt19937 bits(7);
  std::vector<float> terms;
  for (int i = 0; i < count; ++i) {
    const float mantissa = static_cast<float>(static_cast<int32_t>(bits())) * 0x1p-31f;
    terms.push_back(std::ldexp(mantissa, static_cast<int>(bits() % 100) - 60));
  }
  return terms;
}

TEST(ExactSum, OrderDoesNotMatter) {
  std::vector<float> terms = WildTerms(1000000);
  const ExactSum sum = SumOf(terms);
  std::reverse(terms.begin(), terms.end());
  EXPECT_EQ(SumOf(terms), sum);
  std::sort(terms.begin(), terms.end());
  EXPECT_EQ(SumOf(terms), sum);
  std::shuffle(terms.begin(), terms.end(), std::mt19937(8));
  EXPECT_EQ(SumOf(terms), sum);
}

TEST(ExactSum, GroupingDoesNotMatter) {
  const std::vector<float> terms = WildTerms(100000);
  const ExactSum sum = SumOf(terms);
  for (const size_t group : {1, 3, 1000, 99999}) {
    ExactSum merged;
    for (size_t i = 0; i < terms.size(); i += group) {
      ExactSum part;
      for (size_t j = i; j < std::min(i + group, terms.size()); ++j) part.Add(terms[j]);
      merged += part;
    }
    EXPECT_EQ(merged, sum) << group;
  }
}

TEST(ExactSum, KeepsEveryFloatFromAMillionthOn) {
  for (const float x : {0x1p-20f, 1e-6f, 0.1f, -0.3f, 1.0f, 12345.678f, -3e10f, 0.0f}) {
    ExactSum sum;
    sum.Add(x);
    EXPECT_EQ(sum.ToDouble(), x);
  }
}

TEST(ExactSum, OppositesCancelExactly) {
  std::vector<float> terms = WildTerms(1000);
  for (size_t i = 0; i < 1000; ++i) terms.push_back(-terms[i]);
  EXPECT_EQ(SumOf(terms), ExactSum());
  EXPECT_EQ(SumOf(terms).ToDouble(), 0);
}

// In float a million times 0.1 is 100958.3; here every term counts with its own value.
TEST(ExactSum, MillionTermsHaveTheExactSum) {
  EXPECT_EQ(SumOf(std::vector<float>(1000000, 0.1f)).ToDouble(), 1e6 * static_cast<double>(0.1f));
  EXPECT_EQ(SumOf(std::vector<float>(1000000, -0.1f)).ToDouble(), -1e6 * static_cast<double>(0.1f));
}

TEST(ExactSum, TinyTermsRoundToTheNearestUnit) {
  EXPECT_EQ(SumOf({0x1p-44f}).ToDouble(), 0x1p-44);
  EXPECT_EQ(SumOf({0x1.8p-45f}).ToDouble(), 0x1p-44);
  EXPECT_EQ(SumOf({0x1p-46f, std::numeric_limits<float>::denorm_min()}).ToDouble(), 0);
  EXPECT_EQ(SumOf({-0x1.8p-45f}).ToDouble(), -0x1p-44);
}

TEST(ExactSum, HugeTermsCountAsTheLargest) {
  const float inf = std::numeric_limits<float>::infinity();
  EXPECT_EQ(SumOf({1e30f}).ToDouble(), ExactSum::kLargestTerm);
  EXPECT_EQ(SumOf({inf}).ToDouble(), ExactSum::kLargestTerm);
  EXPECT_EQ(SumOf({-inf, 1.0f}).ToDouble(), 1.0 - ExactSum::kLargestTerm);
}

// 2^24 terms of 2^40 leave the integers: the value is wrong, but no order shows.
TEST(ExactSum, WrapsAroundTheSameWayInAnyOrder) {
  ExactSum big;
  big.Add(1e30f);
  for (int i = 0; i < 23; ++i) big += ExactSum(big);  // 2^63
  ExactSum a = big, b;
  a.Add(0.5f);
  a += big;
  b.Add(0.5f);
  b += big;
  b += big;
  EXPECT_EQ(a, b);
  EXPECT_EQ(a.ToDouble(), 0.5);
}

}  // namespace
}  // namespace candela
