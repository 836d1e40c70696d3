// Every scene of the set through the library: the whole output is compared, line by line.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "base/diagnostics.h"
#include "loaders/course/scene_parser.h"
#include "scene/compile_scene.h"
#include "tests/malformed/malformed_set.h"
#include "tests/support/temp_folder.h"

namespace candela {
namespace {

/// What `candela check` says when it stands in the folder of the scene, and its exit code.
std::string Check(const std::filesystem::path& scene) {
  std::filesystem::current_path(scene.parent_path());
  Diagnostics diagnostics;
  const SceneSpec spec = LoadScene(scene.filename(), &diagnostics);
  const bool is_compiled = CompileScene(spec, &diagnostics) != nullptr;
  EXPECT_EQ(is_compiled, !diagnostics.HasErrors());
  std::string output;
  for (const std::string& line : diagnostics.Lines()) {
    EXPECT_LT(line.size(), 500u);
    output += line + "\n";
  }
  return output + fmt::format("exit {}\n", is_compiled ? 0 : static_cast<int>(diagnostics.Code()));
}

class Malformed : public testing::TestWithParam<std::string> {
 protected:
  void TearDown() override { std::filesystem::current_path(start_); }

 private:
  std::filesystem::path start_ = std::filesystem::current_path();
};

TEST_P(Malformed, SaysWhatIsExpected) {
  const auto expected_file = MalformedSet() / (GetParam() + ".expected");
  const std::string expected = ExpectedOutput(GetParam());
  const std::string output = Check(MalformedCopy() / (GetParam() + ".txt"));
  // For new scenes and better messages: writes what is said now, to be read before it is kept.
  if (std::getenv("CANDELA_WRITE_EXPECTED")) testing_support::Put(expected_file, output);
  EXPECT_EQ(output, expected);
}

std::string NameOf(const testing::TestParamInfo<std::string>& scene) {
  std::string name = scene.param;
  std::replace(name.begin(), name.end(), '/', '_');
  return name;
}

/// Settings have a meaning for programs alone: malformed_program_test checks what is said of them.
std::vector<std::string> ScenesWithoutSettings() {
  std::vector<std::string> scenes = MalformedScenes();
  std::erase_if(scenes, [](const std::string& scene) { return scene.starts_with("settings/"); });
  return scenes;
}

INSTANTIATE_TEST_SUITE_P(Set, Malformed, testing::ValuesIn(ScenesWithoutSettings()), NameOf);

TEST(MalformedSet, IsComplete) {
  EXPECT_GE(MalformedScenes().size(), 150u);
  for (const auto& entry : std::filesystem::recursive_directory_iterator(MalformedSet())) {
    if (entry.path().extension() != ".expected") continue;
    auto scene = entry.path();
    EXPECT_TRUE(exists(scene.replace_extension(".txt"))) << entry.path() << " belongs to no scene";
  }
}

}  // namespace
}  // namespace candela
