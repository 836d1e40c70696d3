#include "scene_spec/param_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "base/number.h"
#include "base/text.h"
#include "scene_spec/param_messages.h"

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
bool IsHalfAngle(float value) {
  return value > 0 && value <= 180;
}
bool IsFullAngle(float value) {
  return value > 0 && value <= 360;
}
bool IsFraction(float value) {
  return value >= 0 && value <= 1;
}

}  // namespace

ParamReader::ParamReader(const ParamSet& params, std::string_view object,
                         const SourceLocation& where, Diagnostics* diagnostics, ParamSet* resolved)
    : params_(params),
      where_(where),
      diagnostics_(diagnostics),
      resolved_(resolved),
      use_(params, object, where, diagnostics) {}

/// Keeps what a parameter turned out to be; the last time that it was asked for counts.
void ParamReader::Note(std::string_view name, std::vector<ParamWord> words, bool is_path) {
  if (!resolved_) return;
  std::erase_if(resolved_->params, [&](const Param& param) { return param.name == name; });
  resolved_->params.push_back({std::string(name), where_, std::move(words), is_path});
}

// Numbers are written with the fewest digits that give them back.
float ParamReader::Noted(std::string_view name, float value) {
  if (resolved_) Note(name, {{fmt::format("{}", value), where_}});
  return value;
}

Vec2 ParamReader::Noted(std::string_view name, Vec2 value) {
  if (resolved_) {
    Note(name, {{fmt::format("{}", value.x), where_}, {fmt::format("{}", value.y), where_}});
  }
  return value;
}

Vec3 ParamReader::Noted(std::string_view name, Vec3 value) {
  if (!resolved_) return value;
  std::vector<ParamWord> words;
  for (const float each : {value.x, value.y, value.z}) {
    words.push_back({fmt::format("{}", each), where_});
  }
  Note(name, std::move(words));
  return value;
}

void ParamReader::Error(SourceLocation where, std::string text) {
  diagnostics_->Error(std::move(where), std::move(text));
}

template <class Read>
auto ParamReader::ReadEach(std::string_view name, bool is_required, const Read& read) {
  decltype(read(params_.params[0])) value;
  if (is_required) {
    use_.Require(name);
  } else {
    use_.Know(name);
  }
  for (const Param& param : params_.params) {
    if (param.name == name) value = read(param);
  }
  return value;
}

/// Fills `values` when the parameter is exactly so many legal numbers; reports what else it is.
bool ParamReader::ReadNumbers(const Param& param, const NumberRule& rule, std::span<float> values) {
  for (size_t i = 0; i < param.words.size(); ++i) {
    const ParamWord& word = param.words[i];
    const auto value = ParseFloat(word.text);
    if (!value || !rule.is_legal(*value)) {
      Error(word.where, WrongWord(param.name, rule.expected, word.text, IsTooLarge(word.text)));
      return false;
    }
    if (i == values.size()) {
      Error(word.where, WrongCount(param.name, rule.expected, param.words.size()));
      return false;
    }
    values[i] = *value;
  }
  if (param.words.size() == values.size()) return true;
  use_.AddShortage(param, rule.expected);
  return false;
}

std::optional<float> ParamReader::OneNumber(std::string_view name, bool is_required,
                                            const NumberRule& rule) {
  return ReadEach(name, is_required, [&](const Param& param) -> std::optional<float> {
    std::array<float, 1> value;
    if (!ReadNumbers(param, rule, value)) return std::nullopt;
    return value[0];
  });
}

std::optional<Vec3> ParamReader::ThreeNumbers(std::string_view name, bool is_required,
                                              const NumberRule& rule) {
  return ReadEach(name, is_required, [&](const Param& param) -> std::optional<Vec3> {
    std::array<float, 3> v;
    if (!ReadNumbers(param, rule, v)) return std::nullopt;
    return Vec3{v[0], v[1], v[2]};
  });
}

std::optional<int64_t> ParamReader::OneInteger(std::string_view name, bool is_required,
                                               const IntegerRule& rule) {
  const auto number =
      ReadEach(name, is_required, [&](const Param& param) -> std::optional<int64_t> {
        if (param.words.empty()) {
          use_.AddShortage(param, rule.expected);
          return std::nullopt;
        }
        const std::string& word = param.words[0].text;
        const auto value = ParseInteger(word);
        if (!value || *value < rule.least || *value > rule.most) {
          const bool is_too_large = !value &&
                                    word.find_first_not_of("0123456789", 1) == std::string::npos &&
                                    ParseFloat(word).has_value();
          Error(param.words[0].where, WrongWord(name, rule.expected, word, is_too_large));
          return std::nullopt;
        }
        if (param.words.size() > 1) {
          Error(param.words[1].where, WrongCount(name, rule.expected, param.words.size()));
        }
        return value;
      });
  if (number) Note(name, {{fmt::format("{}", *number), where_}});
  return number;
}

std::optional<int64_t> ParamReader::RequiredInteger(std::string_view name) {
  return OneInteger(
      name, true,
      {"a whole number", std::numeric_limits<int64_t>::min(), std::numeric_limits<int64_t>::max()});
}

int64_t ParamReader::Integer(std::string_view name, int64_t default_value, int64_t least,
                             int64_t most) {
  const IntegerRule rule{fmt::format("a whole number from {} to {}", least, most), least, most};
  if (const auto number = OneInteger(name, false, rule)) return *number;
  Note(name, {{fmt::format("{}", default_value), where_}});
  return default_value;
}

std::optional<ParamWord> ParamReader::OneWord(const Param& param) {
  if (param.words.size() == 1) return param.words[0];
  Error(param.words.empty() ? param.where : param.words[1].where,
        param.words.empty() ? fmt::format("'{}' expects a word, found nothing", param.name)
                            : fmt::format("'{}' expects one word, found {} behind {}", param.name,
                                          Quote(param.words[1].text), Quote(param.words[0].text)));
  return std::nullopt;
}

float ParamReader::Number(std::string_view name, float default_value) {
  return Noted(name, OneNumber(name, false, {"a number", IsAny}).value_or(default_value));
}

float ParamReader::RequiredNumber(std::string_view name) {
  return Noted(name, OneNumber(name, true, {"a number", IsAny}).value_or(0.0f));
}

float ParamReader::Positive(std::string_view name, float default_value) {
  const NumberRule rule{"a positive number", IsPositive};
  return Noted(name, OneNumber(name, false, rule).value_or(default_value));
}

float ParamReader::RequiredPositive(std::string_view name) {
  const NumberRule rule{"a positive number", IsPositive};
  return Noted(name, OneNumber(name, true, rule).value_or(1.0f));
}

float ParamReader::NonNegative(std::string_view name, float default_value) {
  const NumberRule rule{"a number that is not negative", IsNonNegative};
  return Noted(name, OneNumber(name, false, rule).value_or(default_value));
}

float ParamReader::Fraction(std::string_view name, float default_value) {
  const NumberRule rule{"a number from 0 to 1", IsFraction};
  return Noted(name, OneNumber(name, false, rule).value_or(default_value));
}

float ParamReader::RequiredAngle(std::string_view name) {
  const NumberRule rule{"an angle above 0 and below 180 degrees", IsAngle};
  return Noted(name, OneNumber(name, true, rule).value_or(90.0f));
}

float ParamReader::HalfAngle(std::string_view name, float default_value) {
  const NumberRule rule{"an angle above 0 and at most 180 degrees", IsHalfAngle};
  return Noted(name, OneNumber(name, false, rule).value_or(default_value));
}

float ParamReader::FullAngle(std::string_view name, float default_value) {
  const NumberRule rule{"an angle above 0 and at most 360 degrees", IsFullAngle};
  return Noted(name, OneNumber(name, false, rule).value_or(default_value));
}

std::vector<float> ParamReader::RequiredNumberGroups(std::string_view name, size_t group_size,
                                                     const char* expected) {
  const auto numbers = ReadEach(name, true, [&](const Param& param) {
    std::vector<float> values(param.words.size());
    if (!ReadNumbers(param, {expected, IsAny}, values)) return std::vector<float>();
    if (values.empty() || values.size() % group_size != 0) {
      Error(Where(name), WrongCount(name, expected, values.size()));
      return std::vector<float>();
    }
    return values;
  });
  if (!resolved_) return numbers;
  std::vector<ParamWord> words;
  for (const float each : numbers) words.push_back({fmt::format("{}", each), where_});
  Note(name, std::move(words));
  return numbers;
}

Vec2 ParamReader::Pair(std::string_view name, Vec2 default_value) {
  const auto value = ReadEach(name, false, [&](const Param& param) -> std::optional<Vec2> {
    std::array<float, 2> v;
    if (!ReadNumbers(param, {"two numbers", IsAny}, v)) return std::nullopt;
    return Vec2{v[0], v[1]};
  });
  return Noted(name, value.value_or(default_value));
}

Vec3 ParamReader::Vector(std::string_view name, Vec3 default_value) {
  const NumberRule rule{"three numbers", IsAny};
  return Noted(name, ThreeNumbers(name, false, rule).value_or(default_value));
}

Vec3 ParamReader::RequiredVector(std::string_view name) {
  return Noted(name, ThreeNumbers(name, true, {"three numbers", IsAny}).value_or(Vec3()));
}

Vec3 ParamReader::RequiredDirection(std::string_view name) {
  const Vec3 value = ThreeNumbers(name, true, {"three numbers", IsAny}).value_or(Vec3{0, 0, 1});
  if (value != Vec3()) return Noted(name, value);
  Error(Where(name),
        fmt::format("'{}' expects a direction: three numbers, not all of them 0", name));
  return {0, 0, 1};
}

Rgb ParamReader::Color(std::string_view name, Rgb default_value) {
  return Vector(name, default_value);
}

Rgb ParamReader::NonNegativeColor(std::string_view name, Rgb default_value) {
  const NumberRule rule{"three numbers that are not negative", IsNonNegative};
  return Noted(name, ThreeNumbers(name, false, rule).value_or(default_value));
}

Rgb ParamReader::Albedo(std::string_view name, Rgb default_value) {
  const NumberRule rule{"three numbers from 0 to 1", IsFraction};
  return Noted(name, ThreeNumbers(name, false, rule).value_or(default_value));
}

float ParamReader::PositiveOrNamed(std::string_view name, std::span<const NamedNumber> names,
                                   float default_value) {
  const std::optional<float> value = ReadEach(name, false, [&](const Param& param) {
    const auto is_meant = [&](const NamedNumber& named) {
      return param.words.size() == 1 && param.words[0].text == named.name;
    };
    const auto named = std::find_if(names.begin(), names.end(), is_meant);
    if (named != names.end()) return std::optional<float>(named->value);

    std::vector<std::string_view> known;
    for (const NamedNumber& each : names) known.push_back(each.name);
    const std::string expected =
        fmt::format("a positive number or one of {}", ListOf(known, "and"));
    std::array<float, 1> number;
    if (param.words.empty()) {
      Error(param.where, WrongCount(name, expected, 0));
      return std::optional<float>();
    }
    const NumberRule rule{expected.c_str(), IsPositive};
    return ReadNumbers(param, rule, number) ? std::optional<float>(number[0]) : std::nullopt;
  });
  return Noted(name, value.value_or(default_value));
}

size_t ParamReader::Choice(std::string_view name, std::span<const std::string_view> words,
                           size_t default_value) {
  const auto value = ReadEach(name, false, [&](const Param& param) -> std::optional<size_t> {
    const std::optional<ParamWord> word = OneWord(param);
    if (!word) return std::nullopt;
    const auto found = std::find(words.begin(), words.end(), word->text);
    if (found != words.end()) return static_cast<size_t>(found - words.begin());
    Error(word->where, WrongWord(name, ListOf(words), word->text));
    return std::nullopt;
  });
  const size_t choice = value.value_or(default_value);
  Note(name, {{std::string(words[choice]), where_}});
  return choice;
}

bool ParamReader::Flag(std::string_view name, bool default_value) {
  static constexpr std::string_view kWords[] = {"true", "false"};
  return Choice(name, kWords, default_value ? 0 : 1) == 0;
}

ParamWord ParamReader::PlacedWord(std::string_view name, bool is_required) {
  const auto word = ReadEach(name, is_required, [&](const Param& param) { return OneWord(param); });
  return word.value_or(ParamWord{{}, where_});
}

std::string ParamReader::Word(std::string_view name) {
  ParamWord word = PlacedWord(name, false);
  if (!word.text.empty()) Note(name, {word});
  return std::move(word.text);
}

std::string ParamReader::RequiredWord(std::string_view name) {
  ParamWord word = PlacedWord(name, true);
  Note(name, {word});
  return std::move(word.text);
}

ParamWord ParamReader::Path(std::string_view name) {
  ParamWord word = PlacedWord(name, false);
  if (!word.text.empty()) Note(name, {word}, true);
  return word;
}

ParamWord ParamReader::RequiredPath(std::string_view name) {
  ParamWord word = PlacedWord(name, true);
  Note(name, {word}, true);
  return word;
}

bool ParamReader::IsTexture(std::string_view name) {
  if (!Has(name)) return false;
  const Param& param = *params_.Find(name);
  return !param.words.empty() && param.words[0].text == "texture";
}

const ParamWord* ParamReader::TextureName(std::string_view name) {
  const Param& param = *params_.Find(name);
  if (param.words.size() == 2) {
    Note(name, param.words);
    return &param.words[1];
  }
  Error(param.words[0].where, fmt::format("{} expects one name behind 'texture'", Quote(name)));
  return nullptr;
}

SourceLocation ParamReader::Where(std::string_view name) const {
  const Param* param = params_.Find(name);
  if (!param) return where_;
  return param->words.empty() ? param->where : param->words[0].where;
}

}  // namespace candela
