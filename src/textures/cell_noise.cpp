#include "textures/cell_noise.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "textures/gradient_noise.h"

namespace candela {
namespace {

/// From 0 to 1.
float Coordinate(uint32_t bits) {
  return static_cast<float>(bits & 0x3FFu) * (1.0f / 1023);
}

}  // namespace

CellPoints NearestCellPoints(Vec3 p, float jitter) {
  const Vec3 floor{std::floor(p.x), std::floor(p.y), std::floor(p.z)};
  const auto x = static_cast<int32_t>(floor.x), y = static_cast<int32_t>(floor.y),
             z = static_cast<int32_t>(floor.z);
  const Vec3 d = p - floor;
  constexpr float kNone = std::numeric_limits<float>::infinity();
  float nearest = kNone, second = kNone;  // Their squares.
  uint32_t cell = 0;
  const auto look = [&](int i, int j, int k) {
    const uint32_t hash = HashOfCell(x + i, y + j, z + k);
    const Vec3 offset{Coordinate(hash), Coordinate(hash >> 10), Coordinate(hash >> 20)};
    const Vec3 middle{static_cast<float>(i) + 0.5f, static_cast<float>(j) + 0.5f,
                      static_cast<float>(k) + 0.5f};
    const Vec3 from = middle + (offset - Vec3{0.5f, 0.5f, 0.5f}) * jitter - d;
    const float squared = LengthSquared(from);
    if (squared < nearest) {
      second = nearest;
      nearest = squared;
      cell = hash;
    } else if (squared < second) {
      second = squared;
    }
  };
  // Shells of cells around that of the place. What lies in the shell after the one of this radius
  // is at least that far away.
  for (int radius = 0; radius <= 3; ++radius) {
    for (int i = -radius; i <= radius; ++i) {
      for (int j = -radius; j <= radius; ++j) {
        const bool is_inner = std::abs(i) < radius && std::abs(j) < radius;
        const int step = is_inner ? 2 * radius : 1;
        for (int k = -radius; k <= radius; k += std::max(step, 1)) look(i, j, k);
      }
    }
    if (second <= static_cast<float>(radius * radius)) break;
  }
  // The bits have become a place; here they are to say something else.
  return {std::sqrt(nearest), std::sqrt(second), cell * 0x9E3779B1u};
}

}  // namespace candela
