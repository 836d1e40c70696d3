// Every scene of the set through `candela check`, as a user runs it: stderr, stdout, exit code.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "tests/malformed/malformed_set.h"
#include "tests/support/program.h"
#include "tests/support/temp_folder.h"

namespace candela {
namespace {

TEST(MalformedProgram, SaysAndReturnsWhatIsExpected) {
  for (const std::string& scene : MalformedScenes()) {
    const std::filesystem::path path = MalformedCopy() / (scene + ".txt");
    testing_support::ProgramSetup setup;
    setup.folder = path.parent_path();
    const auto end =
        testing_support::RunProgram(CANDELA_PROGRAM, {"check", path.filename()}, setup);
    const std::string output = fmt::format("{}exit {}\n", end.err, end.status);
    // As in malformed_test.
    const bool is_setting = scene.starts_with("settings/");
    if (is_setting && std::getenv("CANDELA_WRITE_EXPECTED")) {
      testing_support::Put(MalformedSet() / (scene + ".expected"), output);
    }
    EXPECT_EQ(output, ExpectedOutput(scene)) << scene;
    // A sound scene is summed up on stdout, a broken one is not.
    EXPECT_EQ(end.out.empty(), end.status != 0) << scene;
  }
}

}  // namespace
}  // namespace candela
