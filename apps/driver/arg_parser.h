#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostics.h"
#include "base/result.h"
#include "driver/arg_value.h"
#include "scene_spec/param_set.h"

namespace candela {

/// How the options of a program are written.
enum class ArgStyle {
  kCourse,  ///< `-size 200 200`, one dash before a word.
  kGnu,     ///< `--size 200 200`, and one dash before a letter: `-o`.
};

/// What else there is to know about an option.
struct ArgTraits {
  char letter = 0;  ///< Short form in the style of GNU.
  bool required = false;
  /// The block of a scene in which the option may stand as well, with '_' for '-' in its name.
  std::string_view block = {};
};

/// Reads a command line by a description of it, which is also its help.
///
/// An option is followed by as many words as it has values; the first may also be joined with '='
/// (`--size=200 200`). A word that looks like an option is never taken for a value, unless it is
/// joined; negative numbers do not look like one. An option with values may be given once only.
/// A flag that may stand in a scene can be turned off: `--shadows=false`.
/// After `--` come only positional arguments. In the course's style two dashes mean the same as
/// one.
class ArgParser {
 public:
  /// What to do after a command line was read.
  enum class Outcome { kRun, kShowHelp, kShowVersion };

  /// `program` as the user calls it, for example "candela render"; `summary` a sentence or more.
  ArgParser(std::string program, std::string summary, ArgStyle style);

  /// Options that follow stand under this headline in the help.
  void Group(std::string title);
  void Flag(std::string name, bool* target, std::string help, ArgTraits traits = {});
  void Option(std::string name, std::vector<ArgValue> values, std::string help,
              ArgTraits traits = {});
  /// A word without an option, which must be given.
  void Positional(ArgValue value, std::string help);
  /// One or more of them; the last positional.
  void PositionalList(ArgValue value, std::string help);
  /// Any number of them; the last positional.
  void OptionalList(ArgValue value, std::string help);
  /// A command line for the end of the help, without the program's name.
  void Example(std::string arguments, std::string help);

  /// Reads the words after the program's name and fills the targets. The error, of code `kUsage`,
  /// is the first one found. A request for help or the version wins over any error.
  Result<Outcome> Parse(std::span<const char* const> words);

  /// Whether the option was given on the command line.
  bool Has(std::string_view name) const;

  /// Gives the parameters of a block of a scene to the options that may stand in it; what is wrong
  /// with them is reported, and an option that was given on the command line keeps its value from
  /// there. Comes after `Parse`, whose words still have to be there.
  void ReadBlock(std::string_view block, const ParamSet& params, Diagnostics* diagnostics);
  /// The options that may stand in a block, with the values that they have now; those that have
  /// none are left out.
  ParamSet ShowBlock(std::string_view block) const;

  /// An option as the user writes it: "-size" or "--size".
  std::string Spell(std::string_view name) const;

  const std::string& program() const { return program_; }
  ArgStyle style() const { return style_; }

  /// Everything that was described, in lines of at most 80 characters.
  std::string Help() const;

 private:
  struct OptionEntry {
    std::string name;
    std::vector<ArgValue> values;
    bool* flag = nullptr;
    std::string help;
    ArgTraits traits;
    size_t group = 0;
    bool given = false;
    std::vector<std::string_view> words = {};  ///< Of its values, as they were given.
  };
  struct PositionalEntry {
    ArgValue value;
    std::string help;
    bool repeats = false;
    bool is_optional = false;
    bool given = false;
  };
  struct ExampleEntry {
    std::string arguments, help;
  };
  class Reader;
  class BlockReader;

  OptionEntry* Find(std::string_view name);
  /// The options that may stand in a block, as they are written there.
  std::vector<std::string> NamesIn(std::string_view block) const;
  std::string LabelOf(const OptionEntry& option) const;
  std::string UsageLine() const;
  std::string BlocksHelp() const;

  std::string program_, summary_;
  ArgStyle style_;
  std::vector<std::string> groups_;
  std::vector<OptionEntry> options_;
  std::vector<PositionalEntry> positionals_;
  std::vector<ExampleEntry> examples_;
};

/// A command line that is wrong.
Error UsageError(std::string message);

/// What follows the name of the program.
std::span<const char* const> WordsOf(int argc, const char* const* argv);

/// Reads the command line of a program and answers requests for help and version on stdout, errors
/// on stderr. The exit status when the program should end now, nothing when it should go on.
std::optional<int> ReadCommandLine(ArgParser& parser, std::span<const char* const> words);

/// Prints name and version on stdout and returns the exit status.
int PrintVersion(const std::string& program);

}  // namespace candela
