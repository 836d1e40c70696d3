#include "scene_spec/param_use.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/text.h"
#include "scene_spec/param_messages.h"

namespace candela {
namespace {

void AddOnce(std::string_view name, std::vector<std::string_view>* names) {
  if (std::find(names->begin(), names->end(), name) == names->end()) names->push_back(name);
}

}  // namespace

bool ParamUse::Know(std::string_view name) {
  AddOnce(name, &known_);
  return params_.Find(name) != nullptr;
}

bool ParamUse::Require(std::string_view name) {
  const bool is_there = Know(name);
  if (!is_there) AddOnce(name, &missing_);
  return is_there;
}

void ParamUse::AddShortage(const Param& param, std::string expected) {
  shortages_.push_back({&param, std::move(expected)});
}

void ParamUse::Report() {
  std::sort(shortages_.begin(), shortages_.end(),
            [](const Shortage& a, const Shortage& b) { return a.param < b.param; });
  auto shortage = shortages_.begin();
  const std::vector<Param>& params = params_.params;
  for (size_t i = 0; i < params.size(); ++i) {
    if (shortage == shortages_.end() || shortage->param != &params[i]) {
      const bool is_known = std::find(known_.begin(), known_.end(), params[i].name) != known_.end();
      if (!is_known) ReportUnused(params[i]);
      continue;
    }
    const Shortage& found = *shortage++;
    const bool is_last = i + 1 == params.size();
    if (is_last && params_.is_damaged) continue;  // The rest of it may be what could not be read.
    const Param* word = WordBetweenNumbers(params_, i, known_);
    ReportShortage(found, word);
    if (word) ++i;
  }
  ReportMissing();
}

void ParamUse::ReportShortage(const Shortage& shortage, const Param* word_instead) {
  const auto& [param, expected] = shortage;
  if (word_instead) {
    diagnostics_.Error(word_instead->where, WrongWord(param->name, expected, word_instead->name));
  } else {
    diagnostics_.Error(param->where, WrongCount(param->name, expected, param->words.size()));
  }
}

void ParamUse::ReportUnused(const Param& param) {
  const auto nearest = Nearest(param.name, known_);
  // Of a misspelt name it needs no saying that it is missing.
  if (nearest) std::erase(missing_, *nearest);
  diagnostics_.Error(param.where, [&] {
    return fmt::format("parameter {} is not used by {}{}", Quote(param.name), Quote(object_),
                       nearest || known_.empty() ? DidYouMean(param.name, known_)
                                                 : fmt::format("; accepted: {}", ListOf(known_)));
  });
}

void ParamUse::ReportMissing() {
  if (params_.is_damaged) return;
  std::vector<std::string_view> needed;
  for (const std::string_view name : missing_) {
    // Where the value before it is missing, a name was taken for that value.
    const bool is_a_value = std::any_of(
        params_.params.begin(), params_.params.end(),
        [&](const Param& param) { return !param.words.empty() && param.words[0].text == name; });
    if (!is_a_value) needed.push_back(name);
  }
  if (needed.empty()) return;
  diagnostics_.Error(where_, fmt::format("{} needs {}", Quote(object_), ListOf(needed, "and")));
}

}  // namespace candela
