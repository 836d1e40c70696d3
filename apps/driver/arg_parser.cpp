#include "driver/arg_parser.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/text.h"
#include "driver/console.h"

namespace candela {
namespace {

/// "-x" and "--x", but neither "-", which is a common name for a stream, nor "-1" and "-.5".
bool LooksLikeOption(std::string_view word) {
  if (word.size() < 2 || word[0] != '-') return false;
  const char second = word[1];
  return !(second >= '0' && second <= '9') && second != '.';
}

std::string JoinLabels(const std::vector<ArgValue>& values) {
  std::string labels;
  for (const ArgValue& value : values) labels += (labels.empty() ? "" : " ") + value.label;
  return labels;
}

/// Stores a word or says why it cannot be one. `name` is the option (or the positional) it is for.
Result<void> Store(const ArgValue& value, std::string_view word, std::string_view name,
                   bool is_one_of_many) {
  if (value.store(word)) return {};
  // A number is no misspelt other number.
  const std::string suggestion = ParseDouble(word) ? "" : DidYouMean(word, value.choices);
  return UsageError(fmt::format("{}: expects {}{}, found {}{}", name, value.expects,
                                is_one_of_many ? " for " + value.label : "", Quote(word),
                                suggestion));
}

}  // namespace

/// The words of one command line on their way into the options of a parser.
class ArgParser::Reader {
 public:
  Reader(ArgParser* parser, std::span<const char* const> words)
      : parser_(*parser), words_(words.begin(), words.end()) {}

  Result<void> ReadAll() {
    bool only_positionals = false;
    while (next_ < words_.size()) {
      const std::string_view word = words_[next_++];
      if (!only_positionals && word == "--") {
        only_positionals = true;
        continue;
      }
      const bool is_option = !only_positionals && LooksLikeOption(word);
      const Result<void> result = is_option ? ReadOption(word) : ReadPositional(word);
      if (!result) return result;
    }
    return CheckRequired();
  }

 private:
  /// What a word that looks like an option says, taken apart.
  struct Written {
    OptionEntry* option = nullptr;
    std::optional<std::string_view> joined;  ///< After '=', or right after a letter.
  };

  Written TakeApart(std::string_view word) const {
    const bool course = parser_.style_ == ArgStyle::kCourse;
    const bool two_dashes = word.substr(0, 2) == "--";
    if (!two_dashes && !course) {
      for (OptionEntry& option : parser_.options_) {
        if (option.traits.letter != word[1]) continue;
        // "-ofile" is "-o file"; a flag has nothing that could follow.
        if (word.size() == 2) return {&option, std::nullopt};
        if (!option.values.empty()) return {&option, word.substr(2)};
      }
      return {};
    }
    const std::string_view rest = word.substr(two_dashes ? 2 : 1);
    const size_t equals = rest.find('=');
    Written written{parser_.Find(rest.substr(0, equals)), std::nullopt};
    if (equals != std::string_view::npos) written.joined = rest.substr(equals + 1);
    return written;
  }

  Result<void> ReadOption(std::string_view word) {
    const auto [option, joined] = TakeApart(word);
    if (option == nullptr) return UnknownOption(word);
    const std::string name = parser_.Spell(option->name);
    if (option->values.empty()) return ReadFlag(option, name, joined);
    if (std::exchange(option->given, true)) return UsageError(name + " is given twice");
    last_with_values_ = option;

    const size_t count = option->values.size();
    size_t found = 0;
    if (joined) {
      option->words.push_back(*joined);
      if (auto result = Store(option->values[found++], *joined, name, count > 1); !result) {
        return result;
      }
    }
    for (; found < count; ++found) {
      if (next_ == words_.size() || LooksLikeOption(words_[next_])) return TooFew(*option, found);
      const std::string_view value = words_[next_++];
      option->words.push_back(value);
      if (auto result = Store(option->values[found], value, name, count > 1); !result) {
        return result;
      }
    }
    return {};
  }

  static Result<void> ReadFlag(OptionEntry* option, const std::string& name,
                               std::optional<std::string_view> joined) {
    const bool is_switch = !option->traits.block.empty();
    if (joined && !is_switch) {
      return UsageError(fmt::format("{}: takes no value, found {}", name, Quote(*joined)));
    }
    if (joined && *joined != "true" && *joined != "false") {
      return UsageError(
          fmt::format("{}: expects 'true' or 'false', found {}", name, Quote(*joined)));
    }
    option->given = true;
    *option->flag = joined != "false";
    return {};
  }

  Result<void> ReadPositional(std::string_view word) {
    for (PositionalEntry& positional : parser_.positionals_) {
      if (positional.given && !positional.repeats) continue;
      positional.given = true;
      return Store(positional.value, word, positional.value.label, false);
    }
    if (last_with_values_ != nullptr) {
      return UsageError(fmt::format("unexpected argument {} after {}", Quote(word),
                                    parser_.LabelOf(*last_with_values_)));
    }
    return UsageError(fmt::format("unexpected argument {}{}", Quote(word), Suggest(word)));
  }

  Result<void> UnknownOption(std::string_view word) const {
    const std::string_view bare = word.substr(std::min(word.find_first_not_of('-'), word.size()));
    return UsageError(fmt::format("unknown option {}{}", Quote(word.substr(0, word.find('='))),
                                  Suggest(bare.substr(0, bare.find('=')))));
  }

  Result<void> TooFew(const OptionEntry& option, size_t found) const {
    const std::string name = parser_.Spell(option.name);
    std::string what = "nothing";
    if (found == 1) what = "only " + Quote(words_[next_ - 1]);
    if (found > 1) what = fmt::format("only {} of {} values", found, option.values.size());
    if (next_ < words_.size()) {
      const std::string_view next = words_[next_];
      what += " before " + Quote(next);
      // A file may have such a name; say how to get it through.
      if (TakeApart(next).option == nullptr && found == 0) {
        what += fmt::format(" (if that is meant as a value, write {}={})", name,
                            CutTo(60, EscapeControl(next.substr(0, 64))));
      }
    }
    return UsageError(
        fmt::format("{}: expects {}, found {}", name, JoinLabels(option.values), what));
  }

  Result<void> CheckRequired() const {
    for (const OptionEntry& option : parser_.options_) {
      if (option.traits.required && !option.given) {
        return UsageError(fmt::format("{} is missing", parser_.LabelOf(option)));
      }
    }
    for (const PositionalEntry& positional : parser_.positionals_) {
      if (!positional.given && !positional.is_optional)
        return UsageError(positional.value.label + " is missing");
    }
    return {};
  }

  std::string Suggest(std::string_view bare) const {
    std::vector<std::string_view> names;
    for (const OptionEntry& option : parser_.options_) names.push_back(option.name);
    const auto nearest = Nearest(bare, names);
    return nearest ? fmt::format(" (did you mean '{}'?)", parser_.Spell(*nearest)) : std::string();
  }

  ArgParser& parser_;
  std::vector<std::string_view> words_;
  size_t next_ = 0;
  const OptionEntry* last_with_values_ = nullptr;
};

ArgParser::ArgParser(std::string program, std::string summary, ArgStyle style)
    : program_(std::move(program)), summary_(std::move(summary)), style_(style) {}

void ArgParser::Group(std::string title) {
  groups_.push_back(std::move(title));
}

void ArgParser::Flag(std::string name, bool* target, std::string help, ArgTraits traits) {
  CHECK(!groups_.empty() && Find(name) == nullptr);
  options_.push_back({std::move(name), {}, target, std::move(help), traits, groups_.size() - 1});
}

void ArgParser::Option(std::string name, std::vector<ArgValue> values, std::string help,
                       ArgTraits traits) {
  CHECK(!groups_.empty() && !values.empty() && Find(name) == nullptr);
  options_.push_back(
      {std::move(name), std::move(values), nullptr, std::move(help), traits, groups_.size() - 1});
}

void ArgParser::Positional(ArgValue value, std::string help) {
  CHECK(positionals_.empty() || !positionals_.back().repeats);
  positionals_.push_back({std::move(value), std::move(help)});
}

void ArgParser::PositionalList(ArgValue value, std::string help) {
  Positional(std::move(value), std::move(help));
  positionals_.back().repeats = true;
}

void ArgParser::OptionalList(ArgValue value, std::string help) {
  PositionalList(std::move(value), std::move(help));
  positionals_.back().is_optional = true;
}

void ArgParser::Example(std::string arguments, std::string help) {
  examples_.push_back({std::move(arguments), std::move(help)});
}

Result<ArgParser::Outcome> ArgParser::Parse(std::span<const char* const> words) {
  // Asked for first: whoever gets a message about another option may well ask for help with it.
  for (const std::string_view word : words) {
    if (word == "--") break;
    const bool course = style_ == ArgStyle::kCourse;
    if (word == "--help" || word == (course ? "-help" : "-h")) return Outcome::kShowHelp;
    if (word == "--version" || (course && word == "-version")) return Outcome::kShowVersion;
  }
  if (const Result<void> result = Reader(this, words).ReadAll(); !result) return result.error();
  return Outcome::kRun;
}

bool ArgParser::Has(std::string_view name) const {
  for (const OptionEntry& option : options_) {
    if (option.name == name) return option.given;
  }
  CHECK(false);
}

std::string ArgParser::Spell(std::string_view name) const {
  return (style_ == ArgStyle::kCourse ? "-" : "--") + std::string(name);
}

ArgParser::OptionEntry* ArgParser::Find(std::string_view name) {
  for (OptionEntry& option : options_) {
    if (option.name == name) return &option;
  }
  return nullptr;
}

std::string ArgParser::LabelOf(const OptionEntry& option) const {
  const std::string name = Spell(option.name);
  return option.values.empty() ? name : name + " " + JoinLabels(option.values);
}

std::optional<int> ReadCommandLine(ArgParser& parser, std::span<const char* const> words) {
  const Result<ArgParser::Outcome> outcome = parser.Parse(words);
  if (!outcome) {
    const int status = PrintError(parser.program(), outcome.error());
    fmt::print(stderr, "Run '{} {}' to see what it takes.\n", parser.program(),
               parser.Spell("help"));
    return status;
  }
  switch (*outcome) {
    case ArgParser::Outcome::kShowHelp:
      return PrintResult(parser.program(), parser.Help());
    case ArgParser::Outcome::kShowVersion:
      return PrintVersion(parser.program());
    case ArgParser::Outcome::kRun:
      break;
  }
  return std::nullopt;
}

Error UsageError(std::string message) {
  return {ErrorCode::kUsage, std::move(message)};
}

std::span<const char* const> WordsOf(int argc, const char* const* argv) {
  const std::span<const char* const> all(argv, static_cast<size_t>(argc));
  return all.subspan(all.empty() ? 0 : 1);
}

int PrintVersion(const std::string& program) {
  return PrintResult(program, "Candela " CANDELA_VERSION "\n");
}

}  // namespace candela
