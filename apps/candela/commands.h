#pragma once

#include <span>
#include <string_view>

namespace candela {

/// The words after the name of a command.
using Words = std::span<const char* const>;

/// A part of the program `candela`. Each reads its words, does its work, prints, and returns the
/// exit status; with the word --help it explains itself.
struct Command {
  std::string_view name;
  std::string_view summary;
  int (*run)(Words words);
};

int RunRenderCommand(Words words);
int RunCheckCommand(Words words);
int RunInfoCommand(Words words);
int RunCompareCommand(Words words);
int RunContactSheetCommand(Words words);

}  // namespace candela
