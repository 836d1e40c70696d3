#include "mesh_parts.h"

#include <algorithm>
#include <cmath>

#include "math/elementary.h"
#include "math/frame.h"
#include "random.h"

namespace candela {
namespace {

/// The derivative of it, and that one's derivative, are 0 at 0 and 1.
float Fade(float x) {
  return x * x * x * (x * (x * 6 - 15) + 10);
}

float Mix(float a, float b, float x) {
  return a + (b - a) * x;
}

/// Random values from -1 to 1 at whole coordinates, smooth in between.
float Noise(Vec3 p) {
  const Vec3 floor{std::floor(p.x), std::floor(p.y), std::floor(p.z)};
  const Vec3 part = p - floor;
  const auto value = [&](int x, int y, int z) {
    const auto cell = [](float low, int step) {
      return static_cast<uint32_t>(static_cast<int32_t>(low) + step);
    };
    const uint32_t hash = Hash(Hash(cell(floor.x, x), cell(floor.y, y)), cell(floor.z, z));
    return static_cast<float>(hash >> 8) * 0x1p-23f - 1;
  };
  const float x = Fade(part.x), y = Fade(part.y), z = Fade(part.z);
  const auto row = [&](int j, int k) { return Mix(value(0, j, k), value(1, j, k), x); };
  const auto layer = [&](int k) { return Mix(row(0, k), row(1, k), y); };
  return z == 0 ? layer(0) : Mix(layer(0), layer(1), z);
}

uint32_t VertexCount(const TriangleMesh& mesh) {
  return static_cast<uint32_t>(mesh.positions.size());
}

}  // namespace

float Fbm(Vec3 p, int octaves) {
  float sum = 0, amplitude = 0.5f;
  for (int octave = 0; octave < octaves; ++octave) {
    sum += amplitude * Noise(p);
    // Not quite twice, so that the lattices of the octaves do not meet.
    p = Vec3{p.z * 1.98f, p.y * 2.01f, p.x * -1.98f} + Vec3{17.3f, 0, 5.1f};
    amplitude *= 0.5f;
  }
  return sum;
}

void AddGrid(int side, const std::function<Vec3(int, int)>& point, TriangleMesh* mesh) {
  const uint32_t first = VertexCount(*mesh), row = static_cast<uint32_t>(side) + 1;
  for (int y = 0; y <= side; ++y) {
    for (int x = 0; x <= side; ++x) mesh->positions.push_back(point(x, y));
  }
  for (uint32_t y = 0; y + 1 < row; ++y) {
    for (uint32_t x = 0; x + 1 < row; ++x) {
      const uint32_t corner = first + y * row + x;
      mesh->triangles.push_back({corner, corner + 1, corner + row + 1});
      mesh->triangles.push_back({corner, corner + row + 1, corner + row});
    }
  }
}

void AddTube(std::span<const Vec3> line, float radius, int sides, TriangleMesh* mesh) {
  const uint32_t first = VertexCount(*mesh), count = static_cast<uint32_t>(sides);
  Vec3 across = Frame::FromNormal(Normalize(line[1] - line[0])).x;
  for (size_t i = 0; i < line.size(); ++i) {
    const Vec3 along = Normalize(line[std::min(i + 1, line.size() - 1)] - line[i == 0 ? 0 : i - 1]);
    // Carried along, the rings do not twist against each other.
    across = Normalize(across - along * Dot(along, across));
    const Vec3 third = Cross(along, across);
    for (uint32_t side = 0; side < count; ++side) {
      const double degrees = 360.0 * side / count;
      mesh->positions.push_back(line[i] +
                                across * (radius * static_cast<float>(CosDegrees(degrees))) +
                                third * (radius * static_cast<float>(SinDegrees(degrees))));
    }
  }
  for (uint32_t ring = 0; ring + 1 < line.size(); ++ring) {
    for (uint32_t side = 0; side < count; ++side) {
      const uint32_t a = first + ring * count + side;
      const uint32_t b = first + ring * count + (side + 1) % count;
      mesh->triangles.push_back({a, b, b + count});
      mesh->triangles.push_back({a, b + count, a + count});
    }
  }
}

void AddBall(Vec3 center, int rows, const std::function<float(Vec3)>& radius, TriangleMesh* mesh) {
  // A pole, rings from north to south, the other pole.
  const uint32_t north = VertexCount(*mesh), ring = static_cast<uint32_t>(2 * rows);
  const auto add = [&](Vec3 direction) {
    mesh->positions.push_back(center + direction * radius(direction));
  };
  add({0, 1, 0});
  for (int row = 1; row < rows; ++row) {
    const double down = 180.0 * row / rows;
    for (uint32_t i = 0; i < ring; ++i) {
      const double around = 360.0 * i / ring;
      add(ToFloat({SinDegrees(down) * CosDegrees(around), CosDegrees(down),
                   SinDegrees(down) * SinDegrees(around)}));
    }
  }
  const uint32_t south = VertexCount(*mesh);
  add({0, -1, 0});
  for (uint32_t i = 0; i < ring; ++i) {
    const uint32_t next = (i + 1) % ring;
    mesh->triangles.push_back({north, north + 1 + next, north + 1 + i});
    for (uint32_t a = north + 1 + i; a + ring < south; a += ring) {
      const uint32_t b = a - i + next;
      mesh->triangles.push_back({a, b, b + ring});
      mesh->triangles.push_back({a, b + ring, a + ring});
    }
    mesh->triangles.push_back({south, south - ring + i, south - ring + next});
  }
}

int BallRows(double triangles) {
  return std::max(2, static_cast<int>(std::lround(0.5 + std::sqrt(triangles / 4))));
}

}  // namespace candela
