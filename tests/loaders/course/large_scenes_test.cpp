// Size is no defect: scenes that nest deeper than a stack, and a megabyte of any one thing, take
// time in proportion to their length.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <functional>

#include "base/clock.h"
#include "loaders/course/scene_parser.h"
#include "scene/compile_scene.h"

namespace candela {
namespace {

const std::string kCamera = "Camera { center 0 0 5 direction 0 0 -1 up 0 1 0 fov 30 }\n";

std::string Repeat(const std::string& text, int count) {
  std::string all;
  for (int i = 0; i < count; ++i) all += text;
  return all;
}

TEST(LargeScenes, AHundredThousandNestedNodesNeedNoStack) {
  constexpr int kDepth = 100000;
  const std::string text = kCamera + "Materials { Material { } } Scene { " +
                           Repeat("Node { Transform { translate 0 0 1 } ", kDepth) +
                           "Component<Material> { index 0 } Component<Object> { type sphere radius "
                           "1 } " +
                           Repeat("}", kDepth + 1);
  Diagnostics diagnostics;
  const SceneSpec spec = ParseScene(nullptr, text, {}, &diagnostics);
  const auto scene = CompileScene(spec, &diagnostics);
  ASSERT_NE(scene, nullptr);
  EXPECT_EQ(spec.nodes.size(), kDepth + 1u);
  ASSERT_EQ(scene->objects().size(), 1u);
  const Vec3 center = scene->objects()[0].world_from_object.Point({0, 0, 0});
  EXPECT_EQ(center, (Vec3{0, 0, kDepth}));
}

/// Texts of about a megabyte of one thing, that quadratic code would read for minutes.
struct Megabyte {
  const char* name;
  std::string text;
};

std::string Numbered(int count, const std::function<std::string(int)>& part) {
  std::string all;
  for (int i = 0; i < count; ++i) all += part(i);
  return all;
}

class MegabyteOf : public testing::TestWithParam<Megabyte> {};

TEST_P(MegabyteOf, TakesLessThanSeconds) {
  const Stopwatch clock;
  Diagnostics diagnostics;
  const auto file = std::make_shared<const std::string>("s");
  const SceneSpec spec = ParseScene(file, GetParam().text, "/nowhere", &diagnostics);
  const auto scene = CompileScene(spec, &diagnostics);
  EXPECT_EQ(scene != nullptr, !diagnostics.HasErrors());
  EXPECT_LE(diagnostics.Lines().size(), 2 * Diagnostics::kMostPerFile + 2);
  // Some 0.1 s; a sanitizer on a busy machine may need many times that.
  EXPECT_LT(clock.Seconds(), 20);
}

const std::string kNoScene = kCamera + "Scene { } ";
const Megabyte kMegabytes[] = {
    {"words", kNoScene + Repeat("x ", 500000)},
    {"numbers", kCamera + "Scene { Transform { scale " + Repeat("1 ", 500000) + "} }"},
    {"one_word", kNoScene + std::string(1 << 20, 'x')},
    {"one_number", kCamera + "Scene { Transform { x_rotate " + std::string(1 << 20, '1') + "} }"},
    {"comments", kNoScene + Repeat("#\n", 500000)},
    {"opening_braces", kNoScene + Repeat("{", 1 << 20)},
    {"closing_braces", kNoScene + Repeat("}", 1 << 20)},
    {"unknown_blocks", kNoScene + Repeat("x{}", 350000)},
    {"misspelt_blocks", kNoScene + Repeat("Camra{}", 150000)},
    {"cameras", kNoScene + Repeat("Camera{x 1}", 100000)},
    {"unclosed_cameras", kNoScene + Repeat("Camera{", 150000)},
    {"unclosed_nodes", kCamera + "Scene {" + Repeat("Node{", 200000)},
    {"steps", kCamera + "Scene { Transform { " + Repeat("y_rotate 1 ", 100000) + "} }"},
    {"misspelt_steps", kCamera + "Scene { Transform { " + Repeat("rotate 1 ", 110000) + "} }"},
    {"parameters", kCamera + "Materials { Material { " +
                       Numbered(100000, [](int i) { return fmt::format("p{} 1 ", i); }) +
                       "} } Scene { }"},
    {"repeated_parameters",
     kCamera + "Materials { Material { " + Repeat("shininess 1 ", 90000) + "} } Scene { }"},
    {"short_parameters", kCamera + "Materials { Material { " +
                             Repeat("shininess } Material { ", 45000) + "} } Scene {}"},
    {"named_materials",
     kCamera + "Materials { " +
         Numbered(50000, [](int i) { return fmt::format("Material{{name m{}}}", i); }) +
         "} Scene { }"},
    {"materials_of_one_name",
     kCamera + "Materials { " + Repeat("Material{name m}", 60000) + "} Scene { }"},
    {"references_by_name",
     kCamera + "Materials { " +
         Numbered(20000, [](int i) { return fmt::format("Material{{name m{}}}", i); }) +
         "} Scene { " +
         Numbered(20000,
                  [](int i) {
                    return fmt::format(
                        "Node{{Component<Material>{{name m{}}}Component<Object>{{type plane normal "
                        "0 1 0 "
                        "offset 1}}}}",
                        i);
                  }) +
         "}"},
    {"unknown_references",
     kCamera + "Materials { " +
         Numbered(20000, [](int i) { return fmt::format("Material{{name m{}}}", i); }) +
         "} Scene { " +
         Numbered(15000,
                  [](int i) {
                    return fmt::format(
                        "Node{{Component<Material>{{name n{}}}Component<Object>{{type sphere "
                        "radius 1}}}}",
                        i);
                  }) +
         "}"},
    {"replaced_objects",
     kCamera + "Scene { " + Repeat("Component<Object>{type sphere radius 1}", 25000) + "}"},
    {"unknown_shapes",
     kCamera + "Scene { " +
         Numbered(25000,
                  [](int i) { return fmt::format("Node{{Component<Object>{{type t{}}}}}", i); }) +
         "}"},
    {"spheres_at_one_place",
     kCamera + "Materials { Material { } } Scene { " +
         Repeat("Node{Component<Material>{index 0}Component<Object>{type sphere radius 1}}",
                14000) +
         "}"},
};

std::string NameOf(const testing::TestParamInfo<Megabyte>& megabyte) {
  return megabyte.param.name;
}

INSTANTIATE_TEST_SUITE_P(Scenes, MegabyteOf, testing::ValuesIn(kMegabytes), NameOf);

}  // namespace
}  // namespace candela
