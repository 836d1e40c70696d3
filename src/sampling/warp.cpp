#include "sampling/warp.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

#include "base/check.h"
#include "base/run_vectorized.h"

namespace candela {
namespace {

constexpr auto kQuarterPi = static_cast<float>(kPi / 4);
constexpr auto kTwoPi = static_cast<float>(2 * kPi);

Vec3 FromHeightAndTurn(float z, float radius, float turn) {
  const auto [sine, cosine] = SinCos(kTwoPi * turn);
  return {radius * static_cast<float>(cosine), radius * static_cast<float>(sine), z};
}

/// The pair, in the other order unless `is_in_order`. Without a branch, which would be mispredicted
/// every other time.
[[gnu::always_inline]] inline Vec2 SwapUnless(bool is_in_order, float first, float second) {
  const auto a = std::bit_cast<uint32_t>(first), b = std::bit_cast<uint32_t>(second);
  const uint32_t difference = (a ^ b) & (uint32_t{is_in_order} - 1);
  return {std::bit_cast<float>(a ^ difference), std::bit_cast<float>(b ^ difference)};
}

/// The azimuth as a part of a full turn, in [0, 1).
float TurnOf(Vec3 direction) {
  const float turn = Atan2(direction.y, direction.x) * (1 / kTwoPi);
  return turn < 0 ? std::min(turn + 1, 0x1.fffffep-1f) : turn;
}

/// A point of the unit disk, and its distance from the centre.
struct DiskPoint {
  Vec2 p;
  float radius;
};

[[gnu::always_inline]] inline DiskPoint DrawOnDisk(Vec2 u) {
  const float x = 2 * u.x - 1;
  const float y = 2 * u.y - 1;
  // In the quadrants left and right of the centre |x| is the radius, in the other two |y|; the
  // smaller one runs along the arc.
  const float radius = std::max(std::abs(x), std::abs(y));
  // In the centre, any.
  const float arc = std::min(std::abs(x), std::abs(y)) / std::max(radius, 1e-30f);
  const auto [sine, cosine] = SinCosOfEighthTurn(kQuarterPi * arc);
  const auto [abs_x, abs_y] = SwapUnless(std::abs(x) > std::abs(y), radius * cosine, radius * sine);
  return {{std::copysign(abs_x, x), std::copysign(abs_y, y)}, radius};
}

[[gnu::always_inline]] inline Vec3 DrawOnCosineHemisphere(Vec2 u) {
  const auto [p, radius] = DrawOnDisk(u);
  // From the radius, which is known earlier than the point.
  return {p.x, p.y, std::sqrt((1 - radius) * (1 + radius))};
}

}  // namespace

Vec2 SampleDisk(Vec2 u) {
  return DrawOnDisk(u).p;
}

Vec2 InvertDisk(Vec2 p) {
  const float radius = std::sqrt(p.x * p.x + p.y * p.y);
  if (radius == 0) return {0.5f, 0.5f};
  float x, y;
  if (std::abs(p.x) > std::abs(p.y)) {
    x = std::copysign(radius, p.x);
    y = x * (Atan(p.y / p.x) / kQuarterPi);
  } else {
    y = std::copysign(radius, p.y);
    x = y * (Atan(p.x / p.y) / kQuarterPi);
  }
  return {0.5f + 0.5f * x, 0.5f + 0.5f * y};
}

Vec3 SampleCosineHemisphere(Vec2 u) {
  return DrawOnCosineHemisphere(u);
}

void SampleCosineHemisphere(std::span<const Vec2> u, std::span<Vec3> directions) {
  DCHECK(u.size() == directions.size());
  constexpr size_t kTogether = 64;
  for (size_t begin = 0; begin < u.size(); begin += kTogether) {
    const size_t count = std::min(kTogether, u.size() - begin);
    // Coordinates stand side by side in vector registers.
    std::array<float, kTogether> u_x{}, u_y{}, x, y, z;
    for (size_t i = 0; i < count; ++i) {
      u_x[i] = u[begin + i].x;
      u_y[i] = u[begin + i].y;
    }
    RunVectorized([&]() __attribute__((always_inline)) {
      for (size_t i = 0; i < kTogether; ++i) {
        const Vec3 direction = DrawOnCosineHemisphere({u_x[i], u_y[i]});
        x[i] = direction.x;
        y[i] = direction.y;
        z[i] = direction.z;
      }
    });
    for (size_t i = 0; i < count; ++i) directions[begin + i] = {x[i], y[i], z[i]};
  }
}

Vec2 InvertCosineHemisphere(Vec3 direction) {
  return InvertDisk({direction.x, direction.y});
}

Vec3 SampleUniformHemisphere(Vec2 u) {
  // The height runs over (0, 1], so no direction lies in the horizon; its distance from 1 is u.x
  // itself, which makes the radius sqrt(1 - z^2) exact near the pole.
  const float z = 1 - u.x;
  return FromHeightAndTurn(z, std::sqrt(u.x * (1 + z)), u.y);
}

Vec2 InvertUniformHemisphere(Vec3 direction) {
  return {1 - direction.z, TurnOf(direction)};
}

Vec3 SampleUniformSphere(Vec2 u) {
  return FromHeightAndTurn(1 - 2 * u.x, 2 * std::sqrt(u.x * (1 - u.x)), u.y);
}

Vec2 InvertUniformSphere(Vec3 direction) {
  return {0.5f - 0.5f * direction.z, TurnOf(direction)};
}

Vec3 SampleCone(Vec2 u, float one_minus_cosine) {
  const float below = u.x * one_minus_cosine;
  return FromHeightAndTurn(1 - below, std::sqrt(below * (2 - below)), u.y);
}

Vec2 InvertCone(Vec3 direction, float one_minus_cosine) {
  // 1 - z from the distance to the axis, which has its digits where z has lost them.
  const float radius2 = direction.x * direction.x + direction.y * direction.y;
  const float below = direction.z > 0 ? radius2 / (1 + direction.z) : 1 - direction.z;
  return {std::min(below / one_minus_cosine, 1.0f), TurnOf(direction)};
}

Vec2 SampleTriangle(Vec2 u) {
  return u.y > u.x ? Vec2{u.x * 0.5f, u.y - u.x * 0.5f} : Vec2{u.x - u.y * 0.5f, u.y * 0.5f};
}

Vec2 InvertTriangle(Vec2 weights) {
  return weights.y > weights.x ? Vec2{2 * weights.x, weights.x + weights.y}
                               : Vec2{weights.x + weights.y, 2 * weights.y};
}

}  // namespace candela
