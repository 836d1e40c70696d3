#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "math/mat4.h"
#include "math/vec.h"

namespace candela {

struct TriangleMesh {
  std::vector<Vec3> positions;
  std::vector<std::array<uint32_t, 3>> triangles;
};

/// A pinhole camera with a square picture.
struct View {
  Vec3 eye, look_at;
  float fov_degrees = 50;
};

struct Ball {
  Vec3 center;
  float radius = 1;
};

/// What both kernels get: one mesh; and perhaps another one, many times in different places.
struct BenchScene {
  std::string name;
  TriangleMesh mesh;
  TriangleMesh part;
  /// Of each instance of `part`: world_from_part, a rotation with the same scale in all directions.
  std::vector<Mat4> instances = {};
  View view;
  Ball light;
  /// Seen from inside, without a way out: every ray hits.
  bool is_closed = false;

  /// As they are seen, each instance counted.
  uint64_t TriangleCount() const {
    return mesh.triangles.size() + part.triangles.size() * instances.size();
  }
};

}  // namespace candela
