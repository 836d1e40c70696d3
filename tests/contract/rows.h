#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <memory>
#include <ostream>
#include <string>
#include <string_view>

#include "cameras/registry.h"
#include "lights/registry.h"
#include "materials/registry.h"
#include "shapes/registry.h"
#include "tests/support/compile_text.h"

// Scenes around the examples of the registries, read by the real parser.

namespace candela::contract {

/// Where the examples' files lie; tests run in the root of the repository.
inline constexpr const char* kExampleFolder = "assets/assignment4";

/// A scene with the one object that `example` describes, under the transforms of two nested nodes.
inline std::unique_ptr<const Scene> SceneOfShape(std::string_view example,
                                                 std::string_view outer = "",
                                                 std::string_view inner = "") {
  return testing_support::CompileText(
      fmt::format("{}Materials {{ Material {{ diffuse 1 1 1 }} }}\n"
                  "Scene {{ Node {{ Transform {{ {} }} Node {{ Transform {{ {} }}\n"
                  "Component<Object> {{ {} }} Component<Material> {{ index 0 }} }} }} }}",
                  testing_support::kCamera, outer, inner, example),
      kExampleFolder);
}

/// A scene whose last material `example` describes, behind those that examples are made of.
inline std::unique_ptr<const Scene> SceneOfMaterial(std::string_view example) {
  return testing_support::CompileText(
      fmt::format("{}Materials {{ Material {{ name iron type conductor metal iron }}\n"
                  "Material {{ name clay type diffuse roughness 0.7 }}\n"
                  "Material {{ {} }} }} Scene {{ }}",
                  testing_support::kCamera, example),
      kExampleFolder);
}

/// A scene whose only light `example` describes, in the node of a sphere, should it need one.
inline std::unique_ptr<const Scene> SceneOfLight(std::string_view example) {
  return testing_support::CompileText(
      fmt::format("{}Textures {{ Texture {{ name slide type checker even 1 0.5 0.2\n"
                  "odd 0.1 0.6 0.9 scale 3 2 }} }}\n"
                  "Materials {{ Material {{ diffuse 1 1 1 }} }}\n"
                  "Scene {{ Component<Object> {{ type sphere radius 1 }}\n"
                  "Component<Material> {{ index 0 }} Component<Light> {{ {} }} }}",
                  testing_support::kCamera, example),
      kExampleFolder);
}

/// For the names of parametrised tests.
template <class Entry>
std::string RowName(const testing::TestParamInfo<Entry>& row) {
  return std::string(row.param.name);
}

}  // namespace candela::contract

namespace candela {

// How failing tests name their row.
inline void PrintTo(const ShapeEntry& entry, std::ostream* out) {
  *out << entry.name;
}
inline void PrintTo(const MaterialEntry& entry, std::ostream* out) {
  *out << entry.name;
}
inline void PrintTo(const CameraEntry& entry, std::ostream* out) {
  *out << entry.name;
}
inline void PrintTo(const LightEntry& entry, std::ostream* out) {
  *out << entry.name;
}

}  // namespace candela
