#include "meshes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "base/diagnostics.h"
#include "forest.h"
#include "geometry/bounds3.h"
#include "loaders/obj/obj_reader.h"
#include "mesh_parts.h"
#include "random.h"

namespace candela {
namespace {

/// Hills of 100 by 100, seen across from a corner.
BenchScene Terrain(double triangles) {
  const int side = std::max(1, static_cast<int>(std::lround(std::sqrt(triangles / 2))));
  BenchScene scene;
  const auto point = [&](int x, int y) {
    const Vec3 p = {100.0f * (static_cast<float>(x) / static_cast<float>(side) - 0.5f), 0,
                    100.0f * (static_cast<float>(y) / static_cast<float>(side) - 0.5f)};
    return p + Vec3{0, 20 * Fbm(p * 0.05f, 11), 0};
  };
  AddGrid(side, point, &scene.mesh);
  scene.view = {{-47, 24, -47}, {0, -4, 0}, 50};
  scene.light = {{30, 30, -20}, 2};
  return scene;
}

/// A ball of 2000 curls that start near its centre.
BenchScene Hairball(double triangles) {
  constexpr uint32_t kHairs = 2000;
  const int pieces = std::max(1, static_cast<int>(std::lround(triangles / kHairs / 6)));
  const float step = 2.5f / static_cast<float>(pieces);
  BenchScene scene;
  for (uint32_t hair = 0; hair < kHairs; ++hair) {
    Random random(Hash(1, hair));
    Vec3 direction = random.Direction();
    std::vector<Vec3> line = {direction * 0.1f};
    for (int i = 0; i < pieces; ++i) {
      const Vec3 p = line.back();
      // Hairs turn as they like, and back where they would leave the ball.
      const float home = 30 * step * std::max(0.0f, Length(p) - 0.9f);
      direction = Normalize(direction + random.Direction() * std::sqrt(2 * step) - p * home);
      line.push_back(p + direction * step);
    }
    AddTube(line, 0.004f, 3, &scene.mesh);
  }
  scene.view = {{0, 0.3f, 2.7f}, {0, 0, 0}, 40};
  scene.light = {{1.5f, 2, 1.5f}, 0.3f};
  return scene;
}

/// One wall of a closed box around the origin: where `axis` is at its lower or upper end. The
/// bumps point inwards and end where walls meet, so that their borders are the same points.
void AddWall(Vec3 half, int axis, bool upper, int side, TriangleMesh* mesh) {
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  const auto coordinate = [&](int a, int i) {
    return half[a] * (static_cast<float>(2 * i - side) / static_cast<float>(side));
  };
  const auto window = [&](int i) {
    const float x = static_cast<float>(i) / static_cast<float>(side);
    return std::min(1.0f, 8 * std::min(x, 1 - x));
  };
  const auto point = [&](int x, int y) {
    Vec3 p;
    p[axis] = coordinate(axis, upper ? side : 0);
    p[u] = coordinate(u, x);
    p[v] = coordinate(v, y);
    const float bump = 0.3f * window(x) * window(y) * std::abs(Fbm(p * 2, 8));
    p[axis] += upper ? -bump : bump;
    return p;
  };
  AddGrid(side, point, mesh);
}

/// A closed box of 10 by 5 by 10 with uneven walls and 60 uneven balls, seen from inside.
BenchScene Room(double triangles) {
  constexpr int kBalls = 60;
  BenchScene scene;
  scene.is_closed = true;
  scene.view = {{-4, 0.5f, -4}, {1, -0.5f, 1}, 70};
  scene.light = {{0, 1.5f, 0}, 0.3f};
  const int side = std::max(1, static_cast<int>(std::lround(std::sqrt(0.4 * triangles / 12))));
  for (int wall = 0; wall < 6; ++wall) {
    AddWall({5, 2.5f, 5}, wall / 2, wall % 2 == 1, side, &scene.mesh);
  }
  const int rows = BallRows(0.6 * triangles / kBalls);
  Random random(2);
  for (int ball = 0; ball < kBalls;) {
    const Vec3 center = random.Point({-4.5f, -2.3f, -4.5f}, {4.5f, 1.5f, 4.5f});
    const float radius = random.Between(0.2f, 0.6f);
    if (Length(center - scene.view.eye) < 1.5f || Length(center - scene.light.center) < 1.2f) {
      continue;
    }
    const Vec3 shift = Vec3{0, 3, 0} * static_cast<float>(ball);
    AddBall(
        center, rows,
        [&](Vec3 direction) { return radius * (1 + 0.3f * Fbm(direction * 3 + shift, 6)); },
        &scene.mesh);
    ++ball;
  }
  return scene;
}

/// What a tree over boxes is bad at: two triangles of 400 m under 3000 slanted beams as thin as
/// needles, and 60 balls whose triangles are as small as a hundredth of a millimetre.
BenchScene Uneven(double triangles) {
  constexpr int kBeams = 3000, kBalls = 60;
  BenchScene scene;
  AddGrid(
      1,
      [](int x, int y) {
        return Vec3{400 * (static_cast<float>(x) - 0.5f), 0, 400 * (static_cast<float>(y) - 0.5f)};
      },
      &scene.mesh);
  Random random(3);
  for (int beam = 0; beam < kBeams; ++beam) {
    const Vec3 foot = random.Point({-60, 0, -60}, {60, 20, 60});
    const Vec3 direction = random.Direction();
    const float length = random.Between(5, 60), radius = random.Between(0.01f, 0.06f);
    const Vec3 ends[] = {foot,
                         foot + Vec3{direction.x, std::abs(direction.y), direction.z} * length};
    AddTube(ends, radius, 4, &scene.mesh);
  }
  const int rows = BallRows((triangles - 8 * kBeams) / kBalls);
  for (int ball = 0; ball < kBalls; ++ball) {
    const float part = static_cast<float>(ball) / (kBalls - 1);
    const float radius = 0.03f + (2 - 0.03f) * part * part;
    const Vec3 center = random.Point({-30, radius, -20}, {30, radius + 8, 40});
    const Vec3 shift = Vec3{0, 3, 0} * static_cast<float>(ball);
    AddBall(
        center, rows,
        [&](Vec3 direction) { return radius * (1 + 0.2f * Fbm(direction * 4 + shift, 6)); },
        &scene.mesh);
  }
  scene.view = {{0, 9, 62}, {0, 4, 0}, 50};
  scene.light = {{20, 40, 30}, 3};
  return scene;
}

/// Embree reads 16 bytes of each vertex, also of the last one.
void LeaveRoom(BenchScene* scene) {
  for (TriangleMesh* mesh : {&scene->mesh, &scene->part}) {
    mesh->positions.reserve(mesh->positions.size() + 1);
  }
}

constexpr double kMillion = 1e6;

}  // namespace

const std::vector<SceneEntry>& SceneEntries() {
  static const std::vector<SceneEntry> kEntries = {
      {"terrain", 1 * kMillion, true, &Terrain},  {"hairball", 1 * kMillion, true, &Hairball},
      {"room", 1 * kMillion, true, &Room},        {"uneven", 1 * kMillion, true, &Uneven},
      {"terrain8", 8 * kMillion, true, &Terrain}, {"forest", 1000 * kMillion, false, &Forest},
  };
  return kEntries;
}

BenchScene MakeScene(const SceneEntry& entry, double scale) {
  BenchScene scene = entry.make(entry.triangles * scale);
  scene.name = entry.name;
  LeaveRoom(&scene);
  return scene;
}

Result<BenchScene> ReadScene(const std::filesystem::path& path) {
  Diagnostics diagnostics;
  const std::shared_ptr<const MeshSpec> spec = LoadObj(path, {}, &diagnostics);
  if (!spec) {
    return Error{ErrorCode::kInput, fmt::format("{} cannot be read\n{}", path.string(),
                                                fmt::join(diagnostics.Lines(), "\n"))};
  }
  if (spec->triangles.empty()) {
    return Error{ErrorCode::kInput, path.string() + ": there are no triangles"};
  }
  Bounds3 bounds;
  for (const auto& corners : spec->triangles) {
    for (const uint32_t corner : corners) bounds.Extend(spec->positions[corner]);
  }
  const Vec3 center = bounds.Center();
  const float size = Length(bounds.Extent());
  BenchScene scene;
  scene.name = path.stem().string();
  scene.mesh = {spec->positions, spec->triangles};
  scene.view = {center + Vec3{0.5f, 0.4f, 0.8f} * size, center, 45};
  scene.light = {center + Vec3{-0.4f, 1, 0.6f} * size, 0.1f * size};
  LeaveRoom(&scene);
  return scene;
}

}  // namespace candela
