// The manual of the command line holds what the programs say about themselves.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <map>
#include <memory>
#include <string>

#include "tests/docs/markdown.h"

namespace candela::docs {
namespace {

/// What a command prints on stdout.
std::string OutputOf(const std::string& command) {
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(::popen(command.c_str(), "r"), ::pclose);
  if (!pipe) return {};
  std::string output;
  for (int c = std::fgetc(pipe.get()); c != EOF; c = std::fgetc(pipe.get())) {
    output += static_cast<char>(c);
  }
  return output;
}

/// Each call as the manual writes it, in the order of the manual, with what runs it.
std::map<std::string, std::string> HelpCalls() {
  const std::string candela = "\"" CANDELA_PROGRAM "\"";
  std::map<std::string, std::string> calls = {
      {"assignment4 -help", "\"" ASSIGNMENT4_PROGRAM "\" -help"},
      {"candela --help", candela + " --help"}};
  for (const std::string command : {"render", "check", "info", "compare", "contact-sheet"}) {
    calls["candela " + command + " --help"] = candela + " " + command + " --help";
  }
  return calls;
}

TEST(CommandLine, HelpOfEveryCommandIsInTheManual) {
  std::map<std::string, std::string> documented;
  for (const FencedBlock& block : FencedBlocks(ReadDocument("docs/command-line.md"))) {
    if (block.Language() == "text") documented[block.Argument()] = block.text;
  }
  for (const auto& [call, command] : HelpCalls()) {
    const std::string help = OutputOf(command);
    ASSERT_FALSE(help.empty()) << command;
    EXPECT_EQ(documented[call], help)
        << "the block \"```text " << call << "\" has to hold what this command prints";
  }
}

TEST(CommandLine, EveryCommandIsChecked) {
  // The list of commands in the general help: two blanks, a word, blanks, an explanation.
  const auto calls = HelpCalls();
  const std::string help = OutputOf(calls.at("candela --help"));
  const size_t begin = help.find("Commands:\n") + 10;
  size_t count = 0;
  for (size_t at = begin; help.compare(at, 2, "  ") == 0; at = help.find('\n', at) + 1) {
    const std::string command = help.substr(at + 2, help.find(' ', at + 2) - at - 2);
    ++count;
    if (command == "help") continue;
    EXPECT_TRUE(calls.contains("candela " + command + " --help")) << command;
  }
  EXPECT_EQ(count, 6u);
}

}  // namespace
}  // namespace candela::docs
