#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "geometry/bounds3.h"
#include "math/mat4.h"
#include "math/vec.h"
#include "tests/sampling/chi_square.h"

namespace candela::test {

/// A triangle mesh that a test makes; with time steps, the positions of one follow those of
/// another.
struct TestMesh {
  std::vector<Vec3> positions;
  std::vector<std::array<uint32_t, 3>> triangles;
  uint32_t steps = 1;

  size_t VertexCount() const { return positions.size() / steps; }
  Bounds3 Bounds() const;
};

/// A point of the cube from -1 to 1.
Vec3 RandomPoint(UniformNumbers* random);
/// One of 0 to count - 1.
uint32_t RandomIndex(UniformNumbers* random, size_t count);

/// Rings of vertices around the y axis between two poles, as a globe is drawn: closed.
TestMesh Globe(uint32_t rings, uint32_t sectors, Vec3 radii = {1, 1, 1});

/// A globe whose radius swings between 1/2 and 1, so that its surface has deep valleys: closed, and
/// the rays from its centre meet it once.
TestMesh Star(uint32_t rings, uint32_t sectors, int spikes);

/// A globe with a radius of its own at each vertex, from 1 - bumps to 1.
TestMesh BumpyGlobe(uint32_t rings, uint32_t sectors, float bumps, UniformNumbers* random);

/// The twelve triangles of a box.
TestMesh BoxMesh(Vec3 low, Vec3 high);

/// The faces of a cube from -1 to 1, in n * n squares each: closed.
TestMesh GridCube(uint32_t n);

/// A piece of a wavy surface of n * n squares over -1 <= x, z <= 1.
TestMesh CurvedGrid(uint32_t n, float height);

/// Triangles without a common vertex, anywhere in the cube from -1 to 1; sizes are spread evenly in
/// their logarithm.
TestMesh Soup(uint32_t count, float smallest, float largest, UniformNumbers* random);

/// Long thin triangles across the cube.
TestMesh Slivers(uint32_t count, float width, UniformNumbers* random);

/// All in one mesh.
TestMesh Join(const std::vector<TestMesh>& meshes);

TestMesh Transformed(TestMesh mesh, const Mat4& matrix);
/// p * scale + offset, in single precision.
TestMesh Moved(TestMesh mesh, float scale, Vec3 offset);

/// The mesh at several moments: each vertex goes its own way, in steps of up to `distance`.
TestMesh InMotion(const TestMesh& mesh, uint32_t steps, float distance, UniformNumbers* random);

}  // namespace candela::test
