// The manual of the command line holds what the programs say about themselves.
#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

#include "tests/docs/markdown.h"
#include "tests/support/program.h"

namespace candela::docs {
namespace {

using testing_support::RunProgram;

const std::vector<std::string> kCommands = {"render", "check", "info", "compare", "contact-sheet"};

/// What each call for help prints, by the call as the manual writes it.
std::map<std::string, std::string> HelpTexts() {
  std::map<std::string, std::string> texts;
  texts["assignment4 -help"] = RunProgram(ASSIGNMENT4_PROGRAM, {"-help"}).out;
  texts["candela --help"] = RunProgram(CANDELA_PROGRAM, {"--help"}).out;
  for (const std::string& command : kCommands) {
    texts["candela " + command + " --help"] = RunProgram(CANDELA_PROGRAM, {command, "--help"}).out;
  }
  return texts;
}

TEST(CommandLine, HelpOfEveryCommandIsInTheManual) {
  std::map<std::string, std::string> shown;
  for (const FencedBlock& block : FencedBlocks(ReadDocument("docs/command-line.md"))) {
    if (block.Language() == "text") shown[block.Argument()] = block.text;
  }
  for (const auto& [call, text] : HelpTexts()) {
    EXPECT_FALSE(text.empty()) << call;
    EXPECT_EQ(shown[call], text) << "the block \"```text " << call << "\" has to hold its output";
  }
}

// The general help lists each command after two blanks.
TEST(CommandLine, EveryCommandIsKnownHere) {
  const std::string help = RunProgram(CANDELA_PROGRAM, {"--help"}).out;
  const std::string headline = "Commands:\n";
  std::vector<std::string> listed;
  for (size_t at = help.find(headline) + headline.size(); help.compare(at, 2, "  ") == 0;
       at = help.find('\n', at) + 1) {
    listed.push_back(help.substr(at + 2, help.find(' ', at + 2) - at - 2));
  }
  std::vector<std::string> expected = kCommands;
  expected.push_back("help");
  EXPECT_EQ(listed, expected);
}

}  // namespace
}  // namespace candela::docs
