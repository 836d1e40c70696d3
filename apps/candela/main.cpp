// The command line of Candela: finds the command, which does the rest.

#include <fmt/format.h>

#include <string>
#include <vector>

#include "base/signals.h"
#include "base/text.h"
#include "candela/commands.h"
#include "driver/arg_parser.h"
#include "driver/console.h"

namespace candela {
namespace {

constexpr Command kCommands[] = {
    {"render", "render a scene into a picture", &RunRenderCommand},
    {"check", "read and check a scene, render nothing", &RunCheckCommand},
    {"info", "show what a scene holds", &RunInfoCommand},
    {"compare", "compare two pictures", &RunCompareCommand},
    {"contact-sheet", "put pictures side by side on one", &RunContactSheetCommand},
};

std::string Help() {
  std::string help = "Usage: candela COMMAND ...\n\nA ray tracer and renderer.\n\nCommands:\n";
  for (const Command& command : kCommands) {
    help += fmt::format("  {:<16}{}\n", command.name, command.summary);
  }
  help += fmt::format("  {:<16}{}\n", "help COMMAND", "explain a command, like COMMAND --help");
  help +=
      "\nExamples:\n"
      "  candela render scene07_arch.txt -o arch.png --shadows --bounces 4\n"
      "  candela check my_scene.txt\n"
      "  candela compare arch.png expected.png --difference difference.png\n"
      "\n"
      "Exit status: 0 done, 1 wrong input, 2 wrong command line, 3 output cannot be\n"
      "written, 4 not enough memory, 5 stopped and saved, 6 pictures differ beyond the\n"
      "threshold of compare, 128+n stopped by signal n.\n";
  return help;
}

int PrintUsageError(std::string_view message) {
  const int status = PrintError("candela", {ErrorCode::kUsage, std::string(message)});
  fmt::print(stderr, "Run 'candela --help' to see the commands.\n");
  return status;
}

int RunCommand(std::string_view name, Words words) {
  std::vector<std::string_view> names;
  for (const Command& command : kCommands) {
    if (command.name == name) return command.run(words);
    names.push_back(command.name);
  }
  names.push_back("help");
  return PrintUsageError(fmt::format("unknown command {}{}", Quote(name), DidYouMean(name, names)));
}

int Run(Words words) {
  if (words.empty()) return PrintUsageError("a command is missing");
  const std::string_view first = words[0];
  if (first == "--version") return PrintVersion("candela");
  if (first == "--help" || first == "-h" || (first == "help" && words.size() == 1)) {
    return PrintResult("candela", Help());
  }
  if (first != "help") return RunCommand(first, words.subspan(1));
  const std::string_view asked = words[1];
  if (asked == "help" || asked == "--help" || asked == "-h") return PrintResult("candela", Help());
  if (words.size() > 2)
    return PrintUsageError(fmt::format("unexpected argument {}", Quote(words[2])));
  static constexpr const char* kExplain[] = {"--help"};
  return RunCommand(asked, kExplain);
}

}  // namespace
}  // namespace candela

int main(int argc, char** argv) {
  candela::ExitOnStopSignals();
  return candela::RunWithinMemory("candela",
                                  [&] { return candela::Run(candela::WordsOf(argc, argv)); });
}
