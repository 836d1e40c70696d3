#include "forest.h"

#include <algorithm>
#include <cmath>

#include "math/frame.h"
#include "mesh_parts.h"
#include "random.h"

namespace candela {
namespace {

constexpr float kHalfSide = 300;

float GroundHeight(float x, float z) {
  return 12 * Fbm(Vec3{x, 0, z} * 0.01f, 4);
}

/// A branch from `start`, bent a bit upwards.
std::vector<Vec3> BranchLine(Vec3 start, Vec3 direction, float length, Random* random) {
  constexpr int kPieces = 8;
  std::vector<Vec3> line = {start};
  for (int i = 0; i < kPieces; ++i) {
    direction = Normalize(direction + random->Direction() * 0.2f + Vec3{0, 0.1f, 0});
    line.push_back(line.back() + direction * (length / kPieces));
  }
  return line;
}

/// Two triangles that share an edge, somewhere around a point.
void AddLeaf(Vec3 p, Random* random, TriangleMesh* mesh) {
  const Frame frame = Frame::FromNormal(random->Direction());
  const float length = random->Between(0.08f, 0.16f), width = 0.4f * length;
  const auto first = static_cast<uint32_t>(mesh->positions.size());
  mesh->positions.insert(
      mesh->positions.end(),
      {p, p + (frame.x * 0.5f + frame.y * 0.3f) * length - frame.z * width * 0.2f,
       p + frame.x * length,
       p + (frame.x * 0.5f - frame.y * 0.3f) * length - frame.z * width * 0.2f});
  mesh->triangles.push_back({first, first + 1, first + 2});
  mesh->triangles.push_back({first, first + 2, first + 3});
}

/// About 6 high: a stem, branches with twigs, and leaves along the twigs for all other triangles.
TriangleMesh Tree(double triangles) {
  constexpr int kBranches = 40, kTwigs = 8;
  Random random(4);
  TriangleMesh mesh;
  std::vector<Vec3> stem;
  for (int i = 0; i <= 20; ++i) {
    const float height = 0.3f * static_cast<float>(i);
    stem.push_back({0.1f * Fbm({height, 0, 1}, 3), height, 0.1f * Fbm({height, 0, 2}, 3)});
  }
  AddTube(stem, 0.12f, 8, &mesh);
  std::vector<std::vector<Vec3>> twigs;
  for (int i = 0; i < kBranches; ++i) {
    const Vec3 start = stem[6 + random.Below(14)];
    const Vec3 out = random.Direction();
    const float length = 2.4f - 0.3f * start.y;
    const auto branch = BranchLine(start, Normalize(Vec3{out.x, 0.3f, out.z}), length, &random);
    AddTube(branch, 0.03f, 5, &mesh);
    for (int k = 0; k < kTwigs; ++k) {
      twigs.push_back(BranchLine(branch[1 + random.Below(8)], random.Direction(), 0.7f, &random));
      AddTube(twigs.back(), 0.008f, 3, &mesh);
    }
  }
  while (static_cast<double>(mesh.triangles.size()) < triangles) {
    const auto& twig = twigs[random.Below(kBranches * kTwigs)];
    AddLeaf(twig[1 + random.Below(8)] + random.Direction() * 0.08f, &random, &mesh);
  }
  return mesh;
}

}  // namespace

BenchScene Forest(double triangles) {
  constexpr int kRows = 100;
  BenchScene scene;
  scene.part = Tree(triangles / (kRows * kRows));
  AddGrid(
      200,
      [](int x, int y) {
        const float px = kHalfSide * (0.01f * static_cast<float>(x) - 1);
        const float pz = kHalfSide * (0.01f * static_cast<float>(y) - 1);
        return Vec3{px, GroundHeight(px, pz), pz};
      },
      &scene.mesh);
  Random random(5);
  for (int i = 0; i < kRows * kRows; ++i) {
    // One in each square of the ground.
    const float square = 2 * kHalfSide / kRows;
    const auto place = [&](int step) {
      return square * (static_cast<float>(step) + random.Real()) - kHalfSide;
    };
    const float x = place(i % kRows), z = place(i / kRows);
    const double scale = random.Between(0.7f, 1.5f);
    scene.instances.push_back(Mat4::Translate({x, GroundHeight(x, z) - 0.1f, z}) *
                              Mat4::Rotate(1, random.Between(0, 360)) *
                              Mat4::Rotate(0, random.Between(-8, 8)) *
                              Mat4::Scale({scale, scale, scale}));
  }
  scene.view = {{-120, GroundHeight(-120, -120) + 18, -120}, {-88, 0, -88}, 50};
  scene.light = {{-40, 60, -40}, 5};
  return scene;
}

}  // namespace candela
