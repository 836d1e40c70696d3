#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

#include "image/image_file.h"
#include "tests/support/program.h"
#include "tests/support/temp_folder.h"

namespace candela::testing_support {

/// A mirroring sphere above a floor, and one light.
inline constexpr const char* kSmallScene = R"(
Camera { center 0 1 8 direction 0 0 -1 up 0 1 0 fov 40 }
Background { color 0.2 0.3 0.5 ambient_light 0.1 0.1 0.1 }
Materials {
  Material { diffuse 0.4 0.2 0.2 specular 0.5 0.5 0.5 shininess 20 }
  Material { diffuse 0.5 0.5 0.5 }
}
Scene {
  Node { Component<Light> { type directional color 1 1 1 direction -1 -1 -1 } }
  Node { Transform { translate 0 1 0 }
         Component<Material> { index 0 } Component<Object> { type sphere radius 1 } }
  Node { Component<Material> { index 1 } Component<Object> { type plane normal 0 1 0 offset 0 } }
}
)";

/// A folder with a scene in it, where programs are run.
class ProgramTest : public testing::Test {
 protected:
  ProgramTest() {
    Put(folder_ / "scene.txt", kSmallScene);
    setup_.folder = folder_.path();
  }

  ProgramEnd Assignment4(const std::vector<std::string>& arguments) const {
    return RunProgram(ASSIGNMENT4_PROGRAM, arguments, setup_);
  }
  ProgramEnd Candela(const std::vector<std::string>& arguments) const {
    return RunProgram(CANDELA_PROGRAM, arguments, setup_);
  }
  /// A picture that was written to the folder.
  Image Picture(const std::string& name) const {
    auto image = ReadImage(folder_ / name);
    if (image) return std::move(image).value();
    ADD_FAILURE() << name << ": " << image.error().message;
    return {};
  }
  /// The bytes of a file in the folder, which must be there.
  std::string Bytes(const std::string& name) const {
    EXPECT_TRUE(std::filesystem::exists(folder_ / name)) << name;
    return Get(folder_ / name);
  }

  /// A number that stands for these bytes: when it differs, no binary data is printed.
  size_t Fingerprint(const std::string& name) const {
    return std::hash<std::string>()(Bytes(name));
  }

  TempFolder folder_;
  ProgramSetup setup_;
};

/// A program that refused to work: the exit status, nothing on stdout, and on stderr one line of
/// this text, for a wrong command line followed by one that leads to the help.
inline void ExpectRefusal(const ProgramEnd& end, int status, const std::string& line) {
  EXPECT_EQ(end.status, status) << end.err;
  EXPECT_EQ(end.out, "");
  EXPECT_EQ(end.err.substr(0, end.err.find('\n')), line);
}

}  // namespace candela::testing_support
