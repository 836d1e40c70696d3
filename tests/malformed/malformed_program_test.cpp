// Every scene of the set through `candela check`, as a user runs it: stderr, stdout, exit code.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/malformed/malformed_set.h"
#include "tests/support/program.h"

namespace candela {
namespace {

TEST(MalformedProgram, SaysAndReturnsWhatIsExpected) {
  for (const std::string& scene : MalformedScenes()) {
    const std::filesystem::path path = MalformedCopy() / (scene + ".txt");
    testing_support::ProgramSetup setup;
    setup.folder = path.parent_path();
    const auto end =
        testing_support::RunProgram(CANDELA_PROGRAM, {"check", path.filename()}, setup);
    EXPECT_EQ(fmt::format("{}exit {}\n", end.err, end.status), ExpectedOutput(scene)) << scene;
    // A sound scene is summed up on stdout, a broken one is not.
    EXPECT_EQ(end.out.empty(), end.status != 0) << scene;
  }
}

}  // namespace
}  // namespace candela
