#include "scene_spec/param_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/number.h"
#include "base/text.h"

namespace candela {
namespace {

bool IsAny(float) {
  return true;
}
bool IsPositive(float value) {
  return value > 0;
}
bool IsNonNegative(float value) {
  return value >= 0;
}
bool IsAngle(float value) {
  return value > 0 && value < 180;
}

}  // namespace

ParamReader::ParamReader(const ParamSet& params, std::string_view object,
                         const SourceLocation& where, Diagnostics* diagnostics)
    : params_(params), object_(object), where_(where), diagnostics_(diagnostics) {}

void ParamReader::Error(SourceLocation where, std::string text) {
  diagnostics_->Error(std::move(where), std::move(text));
}

const Param* ParamReader::Ask(std::string_view name, bool is_required) {
  if (std::find(known_.begin(), known_.end(), name) == known_.end()) known_.push_back(name);
  const Param* param = params_.Find(name);
  if (!param && is_required) Error(where_, fmt::format("{} needs '{}'", Quote(object_), name));
  return param;
}

void ParamReader::Mismatch(const Param& param, const char* expected) {
  // Point at the first word that is not a number; when all are, their count is the mistake.
  for (const ParamWord& word : param.words) {
    if (!ParseFloat(word.text)) {
      Error(word.where,
            fmt::format("'{}' expects {}, found {}", param.name, expected, Quote(word.text)));
      return;
    }
  }
  const size_t count = param.words.size();
  const std::string found =
      count == 0 ? "nothing" : fmt::format("{} number{}", count, count == 1 ? "" : "s");
  Error(param.where, fmt::format("'{}' expects {}, found {}", param.name, expected, found));
}

std::optional<float> ParamReader::OneNumber(std::string_view name, bool is_required,
                                            const char* expected, bool (*is_legal)(float)) {
  const Param* param = Ask(name, is_required);
  if (!param) return std::nullopt;
  const auto value =
      param->words.size() == 1 ? ParseFloat(param->words[0].text) : std::optional<float>();
  if (!value) {
    Mismatch(*param, expected);
  } else if (!is_legal(*value)) {
    Error(param->words[0].where,
          fmt::format("'{}' expects {}, found {}", name, expected, Quote(param->words[0].text)));
    return std::nullopt;
  }
  return value;
}

float ParamReader::Number(std::string_view name, float default_value) {
  return OneNumber(name, false, "a number", IsAny).value_or(default_value);
}

float ParamReader::RequiredNumber(std::string_view name) {
  return OneNumber(name, true, "a number", IsAny).value_or(0.0f);
}

float ParamReader::Positive(std::string_view name, float default_value) {
  return OneNumber(name, false, "a positive number", IsPositive).value_or(default_value);
}

float ParamReader::RequiredPositive(std::string_view name) {
  return OneNumber(name, true, "a positive number", IsPositive).value_or(1.0f);
}

float ParamReader::NonNegative(std::string_view name, float default_value) {
  return OneNumber(name, false, "a number that is not negative", IsNonNegative)
      .value_or(default_value);
}

float ParamReader::RequiredAngle(std::string_view name) {
  return OneNumber(name, true, "an angle between 0 and 180 degrees", IsAngle).value_or(90.0f);
}

int64_t ParamReader::RequiredInteger(std::string_view name) {
  const Param* param = Ask(name, true);
  if (!param) return 0;
  const auto value =
      param->words.size() == 1 ? ParseInteger(param->words[0].text) : std::optional<int64_t>();
  if (value) return *value;
  const bool is_one = param->words.size() == 1;
  Error(is_one ? param->words[0].where : param->where,
        fmt::format(
            "'{}' expects a whole number, found {}", name,
            is_one ? Quote(param->words[0].text) : fmt::format("{} values", param->words.size())));
  return 0;
}

std::optional<Vec3> ParamReader::ThreeNumbers(std::string_view name, bool is_required) {
  const Param* param = Ask(name, is_required);
  if (!param) return std::nullopt;
  if (param->words.size() == 3) {
    const auto x = ParseFloat(param->words[0].text);
    const auto y = ParseFloat(param->words[1].text);
    const auto z = ParseFloat(param->words[2].text);
    if (x && y && z) return Vec3{*x, *y, *z};
  }
  Mismatch(*param, "three numbers");
  return std::nullopt;
}

Vec3 ParamReader::Vector(std::string_view name, Vec3 default_value) {
  return ThreeNumbers(name, false).value_or(default_value);
}

Vec3 ParamReader::RequiredVector(std::string_view name) {
  return ThreeNumbers(name, true).value_or(Vec3());
}

Vec3 ParamReader::RequiredDirection(std::string_view name) {
  const auto value = ThreeNumbers(name, true);
  if (!value) return {0, 0, 1};
  if (*value == Vec3{0, 0, 0}) {
    Error(Where(name), fmt::format("'{}' expects a direction, found 0 0 0", name));
    return {0, 0, 1};
  }
  return *value;
}

Rgb ParamReader::Color(std::string_view name, Rgb default_value) {
  return ThreeNumbers(name, false).value_or(default_value);
}

std::string ParamReader::Word(std::string_view name) {
  const Param* param = Ask(name, false);
  if (!param) return {};
  if (param->words.size() == 1) return param->words[0].text;
  Error(param->where,
        fmt::format("'{}' expects a word, found {}", name,
                    param->words.empty() ? std::string("nothing")
                                         : fmt::format("{} values", param->words.size())));
  return {};
}

std::string ParamReader::RequiredWord(std::string_view name) {
  if (!Ask(name, true)) return {};
  return Word(name);
}

bool ParamReader::Has(std::string_view name) {
  return Ask(name, false) != nullptr;
}

SourceLocation ParamReader::Where(std::string_view name) const {
  const Param* param = params_.Find(name);
  if (!param) return where_;
  return param->words.empty() ? param->where : param->words[0].where;
}

void ParamReader::Finish() {
  for (const Param& param : params_.params) {
    if (std::find(known_.begin(), known_.end(), param.name) != known_.end()) continue;
    Error(param.where, fmt::format("parameter {} is not used by {}{}", Quote(param.name),
                                   Quote(object_), DidYouMean(param.name, known_)));
  }
}

}  // namespace candela
