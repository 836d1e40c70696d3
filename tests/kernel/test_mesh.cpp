#include "tests/kernel/test_mesh.h"

#include <cmath>
#include <functional>
#include <map>
#include <utility>

#include "math/elementary.h"
#include "math/transform.h"

namespace candela::test {
namespace {

/// A globe whose radius is a function of the ring, 0 and rings + 1 being the poles, and the sector.
TestMesh GlobeWith(uint32_t rings, uint32_t sectors,
                   const std::function<double(uint32_t, uint32_t)>& radius) {
  TestMesh globe;
  globe.positions.push_back(ToFloat({0, radius(0, 0), 0}));
  for (uint32_t i = 1; i <= rings; ++i) {
    const double height = kPi * i / (rings + 1);
    for (uint32_t j = 0; j < sectors; ++j) {
      const double turn = 2 * kPi * j / sectors;
      const Vec3d p{Sin(height) * Cos(turn), Cos(height), Sin(height) * Sin(turn)};
      globe.positions.push_back(ToFloat(p * radius(i, j)));
    }
  }
  globe.positions.push_back(ToFloat({0, -radius(rings + 1, 0), 0}));
  const uint32_t last = rings * sectors + 1;
  for (uint32_t j = 0; j < sectors; ++j) {
    const uint32_t k = (j + 1) % sectors;
    globe.triangles.push_back({0, 1 + j, 1 + k});
    for (uint32_t i = 0; i + 1 < rings; ++i) {
      const uint32_t upper = 1 + i * sectors, lower = upper + sectors;
      globe.triangles.push_back({upper + j, lower + j, lower + k});
      globe.triangles.push_back({upper + j, lower + k, upper + k});
    }
    globe.triangles.push_back({last, last - sectors + k, last - sectors + j});
  }
  return globe;
}

}  // namespace

Bounds3 TestMesh::Bounds() const {
  Bounds3 bounds;
  for (const Vec3 p : positions) bounds.Extend(p);
  return bounds;
}

Vec3 RandomPoint(UniformNumbers* random) {
  const Vec2 xy = random->NextPair();
  return {2 * xy.x - 1, 2 * xy.y - 1, 2 * random->Next() - 1};
}

uint32_t RandomIndex(UniformNumbers* random, size_t count) {
  return static_cast<uint32_t>(static_cast<double>(random->Next()) * static_cast<double>(count));
}

TestMesh Globe(uint32_t rings, uint32_t sectors, Vec3 radii) {
  TestMesh globe = GlobeWith(rings, sectors, [](uint32_t, uint32_t) { return 1.0; });
  for (Vec3& p : globe.positions) p = p * radii;
  return globe;
}

TestMesh Star(uint32_t rings, uint32_t sectors, int spikes) {
  return GlobeWith(rings, sectors, [=](uint32_t ring, uint32_t sector) {
    const double height = kPi * ring / (rings + 1), turn = 2 * kPi * sector / sectors;
    return 0.75 + 0.25 * Cos(spikes * turn) * Sin(spikes * height);
  });
}

TestMesh BumpyGlobe(uint32_t rings, uint32_t sectors, float bumps, UniformNumbers* random) {
  return GlobeWith(rings, sectors, [=](uint32_t, uint32_t) {
    return 1 - static_cast<double>(bumps * random->Next());
  });
}

TestMesh BoxMesh(Vec3 low, Vec3 high) {
  TestMesh box;
  for (int i = 0; i < 8; ++i) {
    box.positions.push_back(
        {i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z});
  }
  box.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                   {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return box;
}

TestMesh GridCube(uint32_t n) {
  TestMesh cube;
  std::map<std::array<uint32_t, 3>, uint32_t> known;
  const auto vertex = [&](std::array<uint32_t, 3> at) {
    const auto [place, is_new] =
        known.try_emplace(at, static_cast<uint32_t>(cube.positions.size()));
    if (is_new) {
      Vec3 p;
      for (int axis = 0; axis < 3; ++axis) {
        p[axis] = static_cast<float>(2.0 * at[static_cast<size_t>(axis)] / n - 1);
      }
      cube.positions.push_back(p);
    }
    return place->second;
  };
  for (size_t axis = 0; axis < 3; ++axis) {
    for (const uint32_t side : {0u, n}) {
      for (uint32_t i = 0; i < n * n; ++i) {
        const auto corner = [&](uint32_t du, uint32_t dv) {
          std::array<uint32_t, 3> at{};
          at[axis] = side;
          at[(axis + 1) % 3] = i % n + du;
          at[(axis + 2) % 3] = i / n + dv;
          return vertex(at);
        };
        const uint32_t a = corner(0, 0), b = corner(1, 0), c = corner(1, 1), d = corner(0, 1);
        cube.triangles.push_back({a, b, c});
        cube.triangles.push_back({a, c, d});
      }
    }
  }
  return cube;
}

TestMesh CurvedGrid(uint32_t n, float height) {
  TestMesh grid;
  for (uint32_t i = 0; i <= n; ++i) {
    for (uint32_t j = 0; j <= n; ++j) {
      const double x = 2.0 * i / n - 1, z = 2.0 * j / n - 1;
      grid.positions.push_back(
          ToFloat({x, static_cast<double>(height) * Sin(5 * x) * Cos(4 * z), z}));
    }
  }
  for (uint32_t i = 0; i < n; ++i) {
    for (uint32_t j = 0; j < n; ++j) {
      const uint32_t a = i * (n + 1) + j, b = a + n + 1;
      grid.triangles.push_back({a, b, b + 1});
      grid.triangles.push_back({a, b + 1, a + 1});
    }
  }
  return grid;
}

TestMesh Soup(uint32_t count, float smallest, float largest, UniformNumbers* random) {
  TestMesh soup;
  for (uint32_t i = 0; i < count; ++i) {
    const Vec3 center = RandomPoint(random);
    const float size = smallest * Pow(largest / smallest, random->Next());
    for (int corner = 0; corner < 3; ++corner) {
      soup.positions.push_back(center + RandomPoint(random) * size);
    }
    soup.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  return soup;
}

TestMesh Slivers(uint32_t count, float width, UniformNumbers* random) {
  TestMesh slivers;
  for (uint32_t i = 0; i < count; ++i) {
    const Vec3 from = RandomPoint(random), to = RandomPoint(random);
    slivers.positions.push_back(from);
    slivers.positions.push_back(to);
    slivers.positions.push_back(to + RandomPoint(random) * width);
    slivers.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  return slivers;
}

TestMesh Join(const std::vector<TestMesh>& meshes) {
  TestMesh all;
  for (const TestMesh& mesh : meshes) {
    const auto first = static_cast<uint32_t>(all.positions.size());
    all.positions.insert(all.positions.end(), mesh.positions.begin(), mesh.positions.end());
    for (const auto& [a, b, c] : mesh.triangles) {
      all.triangles.push_back({first + a, first + b, first + c});
    }
  }
  return all;
}

TestMesh Transformed(TestMesh mesh, const Mat4& matrix) {
  const Transform transform(matrix);
  for (Vec3& p : mesh.positions) p = transform.Point(p);
  return mesh;
}

TestMesh Moved(TestMesh mesh, float scale, Vec3 offset) {
  for (Vec3& p : mesh.positions) p = p * scale + offset;
  return mesh;
}

TestMesh InMotion(const TestMesh& mesh, uint32_t steps, float distance, UniformNumbers* random) {
  TestMesh moving = mesh;
  moving.steps = steps;
  for (uint32_t step = 1; step < steps; ++step) {
    for (size_t i = 0; i < mesh.positions.size(); ++i) {
      const Vec3 before = moving.positions[moving.positions.size() - mesh.positions.size()];
      moving.positions.push_back(before + RandomPoint(random) * distance);
    }
  }
  return moving;
}

}  // namespace candela::test
