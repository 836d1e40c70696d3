#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "math/vec.h"

namespace candela {

/// A triangle mesh as it was read: plain data, no acceleration. Positions and normals have separate
/// indices where the file says so.
struct MeshSpec {
  static constexpr uint32_t kNoNormal = 0xFFFFFFFF;
  static constexpr uint32_t kNoUv = 0xFFFFFFFF;

  using Corners = std::array<uint32_t, 3>;

  std::vector<Vec3> positions;
  std::vector<Vec3> normals;       ///< As in the file, not normalised; may be empty.
  std::vector<Corners> triangles;  ///< Into `positions`, counter-clockwise from outside.
  std::vector<Corners>
      normal_corners;     ///< Into `normals` or `kNoNormal`; empty when no corner has one.
  std::vector<Vec2> uvs;  ///< Texture coordinates; may be empty.
  std::vector<Corners> uv_corners;  ///< Into `uvs` or `kNoUv`; empty when no corner has any.
};

}  // namespace candela
