// A reader of the manual finds every kind of object that a scene may name.

#include <gtest/gtest.h>

#include <filesystem>
#include <regex>
#include <span>
#include <string>
#include <string_view>

#include "cameras/registry.h"
#include "lights/registry.h"
#include "materials/registry.h"
#include "shapes/registry.h"
#include "tests/support/temp_folder.h"
#include "textures/registry.h"

namespace candela {
namespace {

const std::filesystem::path kManual = "docs/scene-format.md";

/// The name stands after `type`, as in a scene, or as code of its own.
template <class Entry>
void ExpectNamed(std::span<const Entry> entries, std::string_view kind) {
  const std::string manual = testing_support::Get(kManual);
  for (const Entry& entry : entries) {
    const std::string name(entry.name);
    EXPECT_TRUE(std::regex_search(manual, std::regex("type +" + name + "\\b|`" + name + "`")))
        << kManual << " does not say what the " << kind << " '" << name << "' is";
  }
}

TEST(SceneFormat, NamesEveryShape) {
  ExpectNamed(ShapeEntries(), "shape");
}
TEST(SceneFormat, NamesEveryMaterial) {
  ExpectNamed(MaterialEntries(), "material");
}
TEST(SceneFormat, NamesEveryTexture) {
  ExpectNamed(TextureEntries(), "texture");
}
TEST(SceneFormat, NamesEveryCamera) {
  ExpectNamed(CameraEntries(), "camera");
}
TEST(SceneFormat, NamesEveryLight) {
  ExpectNamed(LightEntries(), "light");
}

}  // namespace
}  // namespace candela
