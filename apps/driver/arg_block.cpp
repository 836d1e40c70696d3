// The options of a command line that may stand in a scene as well.

#include <fmt/format.h>

#include <algorithm>

#include "base/text.h"
#include "driver/arg_parser.h"
#include "scene_spec/param_messages.h"

namespace candela {
namespace {

/// An option as scenes write it.
std::string ParamName(std::string name) {
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

constexpr const char* kTrueOrFalse = "'true' or 'false'";

}  // namespace

/// Gives the parameters of one block to the options of a parser.
class ArgParser::BlockReader {
 public:
  BlockReader(ArgParser* parser, std::string_view block, const ParamSet& params,
              Diagnostics* diagnostics)
      : parser_(*parser),
        block_(block),
        params_(params),
        diagnostics_(*diagnostics),
        names_(parser->NamesIn(block)),
        known_(names_.begin(), names_.end()) {}

  void ReadAll() {
    const std::vector<Param>& params = params_.params;
    for (size_t i = 0; i < params.size(); ++i) {
      OptionEntry* option = Find(params[i].name);
      if (!option || option->traits.block != block_) {
        ReportUnused(params[i], option);
        continue;
      }
      const bool is_short = params[i].words.size() < std::max<size_t>(1, option->values.size());
      const bool is_last = i + 1 == params.size();
      if (is_short && is_last && params_.is_damaged) continue;
      const Param* word = is_short ? WordBetweenNumbers(params_, i, known_) : nullptr;
      if (word) {
        ReportWrong(*option, word->name, params[i].words.size(), word->where);
        ++i;
      } else {
        Read(params[i], option);
      }
    }
  }

 private:
  OptionEntry* Find(std::string_view name) const {
    for (OptionEntry& option : parser_.options_) {
      if (ParamName(option.name) == name) return &option;
    }
    return nullptr;
  }

  /// The command line was read first, but it wins.
  void Read(const Param& param, OptionEntry* option) {
    const bool is_flag = option->values.empty();
    const size_t count = is_flag ? 1 : option->values.size();
    const bool given_flag = is_flag && *option->flag;
    for (size_t i = 0; i < std::min(count, param.words.size()); ++i) {
      const std::string& word = param.words[i].text;
      const bool is_legal =
          is_flag ? word == "true" || word == "false" : option->values[i].store(word);
      if (!is_legal) return ReportWrong(*option, word, i, param.words[i].where);
      if (is_flag) *option->flag = word == "true";
    }
    if (param.words.size() != count) {
      const std::string expected = count == 1
                                       ? ExpectedAt(*option, 0)
                                       : fmt::format("{} values: {}", count, Labels(*option));
      diagnostics_.Error(param.words.size() < count ? param.where : param.words[count].where,
                         WrongCount(param.name, expected, param.words.size()));
    }
    if (!option->given) return;
    if (is_flag) *option->flag = given_flag;
    for (size_t i = 0; i < option->words.size(); ++i) option->values[i].store(option->words[i]);
  }

  static std::string ExpectedAt(const OptionEntry& option, size_t i) {
    if (option.values.empty()) return kTrueOrFalse;
    const ArgValue& value = option.values[i];
    return value.expects + (option.values.size() > 1 ? " for " + value.label : "");
  }

  static std::string Labels(const OptionEntry& option) {
    std::string labels;
    for (const ArgValue& value : option.values) labels += (labels.empty() ? "" : " ") + value.label;
    return labels;
  }

  void ReportWrong(const OptionEntry& option, std::string_view word, size_t i,
                   const SourceLocation& where) {
    const std::string suggestion =
        option.values.empty() ? std::string() : DidYouMean(word, option.values[i].choices);
    diagnostics_.Error(where,
                       WrongWord(ParamName(option.name), ExpectedAt(option, i), word) + suggestion);
  }

  void ReportUnused(const Param& param, const OptionEntry* option) {
    diagnostics_.Error(param.where, [&] {
      if (option && option->traits.block.empty()) {
        return fmt::format("{} is for the command line alone: a scene cannot set it",
                           Quote(param.name));
      }
      if (option) {
        return fmt::format("{} belongs in the block {}, not in {}", Quote(param.name),
                           Quote(option->traits.block), Quote(block_));
      }
      return fmt::format("parameter {} is not used by {}{}", Quote(param.name), Quote(block_),
                         Nearest(param.name, known_)
                             ? DidYouMean(param.name, known_)
                             : fmt::format("; accepted: {}", ListOf(known_)));
    });
  }

  ArgParser& parser_;
  std::string_view block_;
  const ParamSet& params_;
  Diagnostics& diagnostics_;
  std::vector<std::string> names_;
  std::vector<std::string_view> known_;  ///< The same.
};

void ArgParser::ReadBlock(std::string_view block, const ParamSet& params,
                          Diagnostics* diagnostics) {
  BlockReader(this, block, params, diagnostics).ReadAll();
}

ParamSet ArgParser::ShowBlock(std::string_view block) const {
  ParamSet set;
  for (const OptionEntry& option : options_) {
    if (option.traits.block != block) continue;
    Param param{ParamName(option.name), {}, {}};
    if (option.flag) param.words.push_back({*option.flag ? "true" : "false", {}});
    for (const ArgValue& value : option.values) param.words.push_back({value.show(), {}});
    const bool has_value = std::none_of(param.words.begin(), param.words.end(),
                                        [](const ParamWord& word) { return word.text.empty(); });
    if (has_value) set.params.push_back(std::move(param));
  }
  return set;
}

std::vector<std::string> ArgParser::NamesIn(std::string_view block) const {
  std::vector<std::string> names;
  for (const OptionEntry& option : options_) {
    if (option.traits.block == block) names.push_back(ParamName(option.name));
  }
  return names;
}

}  // namespace candela
