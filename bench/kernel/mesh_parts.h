#pragma once

#include <functional>
#include <span>

#include "bench_scene.h"
#include "math/vec.h"

namespace candela {

// What the meshes are put together from. Each adds triangles, with vertices of their own, to
// a mesh.

/// Smooth noise of several octaves, each of twice the frequency and half the amplitude, about -1 to
/// 1.
float Fbm(Vec3 p, int octaves);

/// A grid of side * side squares, two triangles each; `point(x, y)` for 0 <= x, y <= side.
void AddGrid(int side, const std::function<Vec3(int, int)>& point, TriangleMesh* mesh);

/// A tube of flat sides around a line of points, 2 * sides triangles for each piece; open at its
/// ends.
void AddTube(std::span<const Vec3> line, float radius, int sides, TriangleMesh* mesh);

/// A closed ball, 4 * rows * (rows - 1) triangles, with `radius(direction)` in each direction.
void AddBall(Vec3 center, int rows, const std::function<float(Vec3)>& radius, TriangleMesh* mesh);
/// The rows of a ball of about so many triangles.
int BallRows(double triangles);

}  // namespace candela
