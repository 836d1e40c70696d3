#include "materials/sheen_table.h"

#include <algorithm>
#include <cmath>

#include "materials/table_place.h"
#include "math/elementary.h"

namespace candela {
namespace {

// Rows stand at even steps of the roughness. Columns stand at the squares of 0, 1/31, ... 1: close
// to each other at the horizon, where the share changes fast.
constexpr int kRows = 32, kColumns = 32;
constexpr float kNearestToHorizon = 1e-4f;

size_t CellOf(int row, int column) {
  return static_cast<size_t>(row) * kColumns + static_cast<size_t>(column);
}

float Fibres(float roughness, const Vec3& wo, const Vec3& wi) {
  const Vec3 half = wo + wi;
  const float cos2 = half.z * half.z / LengthSquared(half);
  const float exponent = 1 / roughness;
  const float sine_power = Pow(std::max(0.0f, 1 - cos2), 0.5f * exponent);
  constexpr auto kInverseTurn = static_cast<float>(1 / (2 * kPi));
  return (2 + exponent) * kInverseTurn * sine_power / (4 * (wo.z + wi.z - wo.z * wi.z));
}

float ShareOf(float roughness, float cosine) {
  constexpr int kHeights = 48, kTurns = 48;
  const Vec3 wo{std::sqrt(std::max(0.0f, 1 - cosine * cosine)), 0, cosine};
  // The other half of the turn has the same values.
  Vec2 turns[kTurns];
  for (int j = 0; j < kTurns; ++j) {
    const float phi = static_cast<float>(kPi) * (static_cast<float>(j) + 0.5f) / kTurns;
    turns[j] = {Cos(phi), Sin(phi)};
  }
  double sum = 0;
  for (int i = 0; i < kHeights; ++i) {
    // Heights are crowded at the horizon.
    const float root = (static_cast<float>(i) + 0.5f) / kHeights;
    const float z = root * root, sine = std::sqrt(1 - z * z);
    double ring = 0;
    for (const Vec2 turn : turns) {
      ring += static_cast<double>(Fibres(roughness, wo, {sine * turn.x, sine * turn.y, z}));
    }
    sum += ring * static_cast<double>(z) * 2 * static_cast<double>(root);
  }
  return static_cast<float>(sum * 2 * kPi / (kHeights * kTurns));
}

TablePlace RowOf(float roughness) {
  constexpr float kRange = 1 - SheenTable::kSmoothest;
  return {(roughness - SheenTable::kSmoothest) / kRange * (kRows - 1), kRows};
}

}  // namespace

SheenTable::SheenTable() : shares_(size_t{kRows} * kColumns), scales_(kRows) {
  for (int row = 0; row < kRows; ++row) {
    const float part = static_cast<float>(row) / (kRows - 1);
    const float roughness = kSmoothest + (1 - kSmoothest) * part;
    float most = 1;
    for (int column = 0; column < kColumns; ++column) {
      const float root = static_cast<float>(column) / (kColumns - 1);
      const float share = ShareOf(roughness, std::max(root * root, kNearestToHorizon));
      shares_[CellOf(row, column)] = share;
      most = std::max(most, share);
    }
    scales_[static_cast<size_t>(row)] = 1 / most;
    for (int column = 0; column < kColumns; ++column) shares_[CellOf(row, column)] *= 1 / most;
  }
}

// On one thread, in a few hundredths of a second: one that waited for others here might be given
// work that asks for the table again.
const SheenTable& SheenTable::Get() {
  static const SheenTable table;
  return table;
}

float SheenTable::ScaleOf(float roughness) const {
  const TablePlace row = RowOf(roughness);
  const float* here = &scales_[static_cast<size_t>(row.index)];
  return row.Blend(here[0], here[1]);
}

float SheenTable::Value(float roughness, const Vec3& wo, const Vec3& wi) const {
  return ScaleOf(roughness) * Fibres(std::max(roughness, kSmoothest), wo, wi);
}

float SheenTable::At(float cosine, float roughness) const {
  const TablePlace row = RowOf(roughness), column(std::sqrt(cosine) * (kColumns - 1), kColumns);
  const float* here = &shares_[CellOf(row.index, column.index)];
  return row.Blend(column.Blend(here[0], here[1]),
                   column.Blend(here[kColumns], here[kColumns + 1]));
}

}  // namespace candela
