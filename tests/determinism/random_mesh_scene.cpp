#include "tests/determinism/random_mesh_scene.h"

#include <gtest/gtest.h>

#include <memory>
#include <random>
#include <string>
#include <utility>

#include "loaders/course/scene_parser.h"

namespace candela::determinism {
namespace {

/// Adds meshes and nodes with numbers from a generator whose sequence the standard fixes. One draw
/// for each statement: the order within one is not fixed.
class MeshAdder {
 public:
  MeshAdder(uint32_t seed, SceneSpec* spec) : random_(seed), spec_(*spec) {}

  /// Hills over n * n squares, from -1 to 1; some corners have normals when asked for.
  void AddMesh(const std::string& name, uint32_t n, bool has_normals) {
    auto mesh = std::make_shared<MeshSpec>();
    for (uint32_t z = 0; z <= n; ++z) {
      for (uint32_t x = 0; x <= n; ++x) {
        const auto side = static_cast<double>(n);
        mesh->positions.push_back(ToFloat({2 * x / side - 1, Number(-0.1, 0.1), 2 * z / side - 1}));
        if (x == n || z == n) continue;
        const uint32_t a = z * (n + 1) + x, b = a + 1, c = a + n + 1, d = c + 1;
        mesh->triangles.push_back({a, c, b});
        mesh->triangles.push_back({b, c, d});
      }
    }
    if (has_normals) {
      for (int i = 0; i < 20; ++i) {
        const double x = Number(-0.5, 0.5);
        const double z = Number(-0.5, 0.5);
        mesh->normals.push_back(ToFloat({x, Number(0, 1), z}));
      }
      for (size_t i = 0; i < mesh->triangles.size(); ++i) {
        MeshSpec::Corners corners;
        for (uint32_t& corner : corners) {
          corner = Below(4) == 0 ? MeshSpec::kNoNormal : Below(20);
        }
        mesh->normal_corners.push_back(corners);
      }
    }
    spec_.meshes[name] = std::move(mesh);
  }

  void AddNode(const std::string& mesh) {
    NodeSpec node;
    const double x = Number(-2, 2);
    const double y = Number(-1.5, 2);
    node.parent_from_node = Mat4::Translate({x, y, Number(-2, 2)});
    for (int axis = 0; axis < 3; ++axis) {
      node.parent_from_node = node.parent_from_node * Mat4::Rotate(axis, Number(-180, 180));
    }
    const double mirror = Below(2) == 0 ? -1 : 1;
    const double width = Number(0.3, 1.2);
    node.parent_from_node =
        node.parent_from_node * Mat4::Scale({mirror * width, Number(0.3, 2), Number(0.3, 1.2)});
    node.parent = 0;
    node.object = TypedSpec{"mesh", {}, {{{"obj_file", {}, {{mesh, {}}}}}}};
    node.material = MaterialReference{{}, Below(3), {}};
    spec_.nodes.push_back(std::move(node));
  }

 private:
  /// Thousandths from `least` to `most`.
  double Number(double least, double most) {
    return least + (most - least) * (static_cast<double>(random_() % 1001) / 1000);
  }
  uint32_t Below(uint32_t count) { return static_cast<uint32_t>(random_() % count); }

  std::mt19937 random_;
  SceneSpec& spec_;
};

}  // namespace

SceneSpec RandomMeshScene(uint32_t seed, const std::string& rest) {
  Diagnostics diagnostics;
  SceneSpec spec = ParseScene(std::make_shared<const std::string>("text"), rest, ".", &diagnostics);
  EXPECT_FALSE(diagnostics.HasErrors());
  MeshAdder adder(seed, &spec);
  adder.AddMesh("once", 12, seed % 2 == 0);
  adder.AddMesh("small", 3, seed % 3 == 0);
  adder.AddMesh("large", 20, seed % 2 == 1);
  for (const char* name : {"once", "small", "large", "small", "large", "large"}) {
    adder.AddNode(name);
  }
  return spec;
}

void SetInMotion(uint32_t seed, SceneSpec* spec) {
  std::mt19937 random(seed + 1000);
  const auto number = [&] { return static_cast<double>(random() % 1001) / 1000 - 0.5; };
  for (size_t i = 0; i < spec->nodes.size(); ++i) {
    NodeSpec& node = spec->nodes[i];
    if (!node.object || node.light || node.object->type == "plane") continue;
    node.motion = {node.parent_from_node};
    for (size_t step = 0; step < 1 + i % 3 / 2; ++step) {
      const double x = number(), y = number(), turn = 60 * number(), size = 1 + 0.5 * number();
      const Mat4 next = Mat4::Translate({x, y, 0}) * node.motion.back();
      node.motion.push_back(next * Mat4::Rotate(1, turn) * Mat4::Scale({size, 1, 1}));
    }
  }
  spec->camera.params.params.push_back({"up_end", {}, {{"0.1", {}}, {"1", {}}, {"0.05", {}}}});
}

}  // namespace candela::determinism
