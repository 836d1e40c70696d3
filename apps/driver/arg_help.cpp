// The help of a command line: usage, summary, grouped options and examples.

#include <fmt/format.h>

#include <algorithm>

#include "driver/arg_parser.h"

namespace candela {
namespace {

constexpr size_t kWidth = 80;
constexpr size_t kHelpColumn = 26;

/// Breaks `text` at blanks into lines that end before `kWidth`. The first begins at the column
/// `start`, the others are indented by `indent` blanks.
std::string Wrap(std::string_view text, size_t start, size_t indent) {
  std::string wrapped;
  size_t column = start;
  bool first_word = true;
  while (!text.empty()) {
    const std::string_view word = text.substr(0, text.find(' '));
    text.remove_prefix(std::min(text.size(), word.size() + 1));
    if (!first_word && column + 1 + word.size() > kWidth) {
      wrapped += "\n" + std::string(indent, ' ');
      column = indent;
    } else if (!first_word) {
      wrapped += ' ';
      ++column;
    }
    wrapped += word;
    column += word.size();
    first_word = false;
  }
  return wrapped + "\n";
}

/// A label in the left column, its explanation in the right one.
std::string Row(const std::string& label, std::string_view help) {
  std::string row = "  " + label;
  if (row.size() + 2 > kHelpColumn) row += "\n";
  const size_t column = row.back() == '\n' ? 0 : row.size();
  row.append(kHelpColumn - column, ' ');
  return row + Wrap(help, kHelpColumn, kHelpColumn);
}

}  // namespace

std::string ArgParser::UsageLine() const {
  std::string usage = "Usage: " + program_;
  const size_t indent = usage.size() + 1;
  std::string rest;
  for (const PositionalEntry& positional : positionals_) {
    const std::string words = positional.value.label + (positional.repeats ? "..." : "");
    rest += positional.is_optional ? " [" + words + "]" : " " + words;
  }
  for (const OptionEntry& option : options_) {
    if (option.traits.required) rest += " " + LabelOf(option);
  }
  rest += " [options]";
  return usage + " " + Wrap(std::string_view(rest).substr(1), indent, indent);
}

/// Which options scenes may set, block by block.
std::string ArgParser::BlocksHelp() const {
  std::vector<std::string_view> blocks;
  for (const OptionEntry& option : options_) {
    const std::string_view block = option.traits.block;
    const bool is_known = std::find(blocks.begin(), blocks.end(), block) != blocks.end();
    if (!block.empty() && !is_known) blocks.push_back(block);
  }
  if (blocks.empty()) return {};
  std::sort(blocks.begin(), blocks.end());
  std::string help = "\nIn the scene (the command line wins; --FLAG=false turns a flag off):\n";
  for (const std::string_view block : blocks) {
    help +=
        Row(fmt::format("{} {{ ... }}", block), fmt::format("{}", fmt::join(NamesIn(block), ", ")));
  }
  return help;
}

std::string ArgParser::Help() const {
  std::string help = UsageLine() + "\n" + Wrap(summary_, 0, 0);

  if (!positionals_.empty()) help += "\nArguments:\n";
  for (const PositionalEntry& positional : positionals_) {
    help += Row(positional.value.label + (positional.repeats ? "..." : ""), positional.help);
  }
  for (size_t group = 0; group < groups_.size(); ++group) {
    help += fmt::format("\n{}:\n", groups_[group]);
    for (const OptionEntry& option : options_) {
      if (option.group != group) continue;
      const char letter = option.traits.letter;
      help += Row((letter ? fmt::format("-{}, ", letter) : "") + LabelOf(option), option.help);
    }
  }
  help += BlocksHelp();
  help += "\nHelp:\n";
  help += Row(style_ == ArgStyle::kCourse ? Spell("help") : "-h, " + Spell("help"), "show this");
  help += Row(Spell("version"), "show the version");

  if (!examples_.empty()) help += "\nExamples:\n";
  for (const ExampleEntry& example : examples_) {
    // Not wrapped, so that it can be copied into a shell.
    help += fmt::format("  {} {}\n      {}", program_, example.arguments, Wrap(example.help, 6, 6));
  }
  return help;
}

}  // namespace candela
