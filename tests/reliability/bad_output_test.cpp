// Outputs that cannot be written, and pictures that do not fit, are refused before work is lost.
#include "tests/apps/programs.h"

namespace candela::testing_support {
namespace {

using testing::ElementsAre;

/// A scene that is wrong shows by its exit status whether it was read before the outputs were
/// checked.
class BadOutput : public ProgramTest {
 protected:
  BadOutput() { Put(folder_ / "broken.txt", "nonsense"); }

  void ExpectRefusedBeforeReading(const std::vector<std::string>& outputs,
                                  const std::string& message) const {
    std::vector<std::string> arguments = {"-input", "broken.txt"};
    arguments.insert(arguments.end(), outputs.begin(), outputs.end());
    ExpectRefusal(Assignment4(arguments), 3, "assignment4: error: " + message);
    EXPECT_EQ(Assignment4({"-input", "broken.txt", "-output", "fine.png"}).status, 1);
  }
};

TEST_F(BadOutput, AFolderIsRefusedBeforeTheSceneIsRead) {
  std::filesystem::create_directory(folder_ / "folder.png");
  ExpectRefusedBeforeReading({"-output", "folder.png"}, "'folder.png': is a folder");
}

TEST_F(BadOutput, AMissingFolderIsRefusedBeforeTheSceneIsRead) {
  ExpectRefusedBeforeReading({"-output", "missing/o.png"},
                             "'missing/o.png': its folder does not exist");
}

TEST_F(BadOutput, EachOfSeveralIsCheckedBeforeAnyIsWritten) {
  Put(folder_ / "fine.png", "old");
  ExpectRefusedBeforeReading({"-output", "fine.png", "-normals", "missing/n.png"},
                             "'missing/n.png': its folder does not exist");
  ExpectRefusedBeforeReading({"-output", "fine.png", "-depth", "0", "1", "missing/d.png"},
                             "'missing/d.png': its folder does not exist");
  EXPECT_TRUE(Bytes("fine.png") == "old");
}

// The sanitizer reserves more address space than the limit leaves.
#if defined(__SANITIZE_ADDRESS__)
#define CANDELA_HAS_ADDRESS_SANITIZER
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define CANDELA_HAS_ADDRESS_SANITIZER
#endif
#endif
#ifndef CANDELA_HAS_ADDRESS_SANITIZER
TEST_F(BadOutput, MemoryThatIsRefusedByTheSystemIsAnOrdinaryError) {
  Put(folder_ / "o.png", "old");
  // The estimate knows nothing of this limit, so that the allocation itself fails.
  const ProgramEnd end = RunProgram(
      "/bin/sh",
      {"-c", "ulimit -v 400000; exec \"$0\" -input scene.txt -output o.png -size 10000 10000",
       ASSIGNMENT4_PROGRAM},
      setup_);
  ExpectRefusal(end, 4, "assignment4: error: the memory is not sufficient");
  EXPECT_TRUE(Bytes("o.png") == "old");
  EXPECT_THAT(folder_.Names(), ElementsAre("broken.txt", "o.png", "scene.txt"));
}
#endif

}  // namespace
}  // namespace candela::testing_support
