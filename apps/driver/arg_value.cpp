#include "driver/arg_value.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/text.h"

namespace candela {
namespace {

template <class Target>
ArgValue FileInto(std::string label, Target* target) {
  return {std::move(label), "the name of a file", [=](std::string_view text) {
            if (text.empty()) return false;
            *target = std::filesystem::path(text);
            return true;
          }};
}

/// What a target holds, as a word; empty for an optional one that holds nothing.
template <class T>
std::string Show(const T& value) {
  return fmt::format("{}", value);
}
template <class T>
std::string Show(const std::optional<T>& value) {
  return value ? Show(*value) : std::string();
}

template <class Target>
ArgValue ChoiceInto(std::string label, Target* target, std::vector<std::string_view> choices) {
  const auto store = [target, choices](std::string_view text) {
    if (std::find(choices.begin(), choices.end(), text) == choices.end()) return false;
    *target = std::string(text);
    return true;
  };
  return {std::move(label), ListOf(choices), store, choices, [target] { return Show(*target); }};
}

template <class Target>
ArgValue RealInto(std::string label, Target* target) {
  const auto store = [target](std::string_view text) {
    const auto value = ParseFloat(text);
    if (value) *target = *value;
    return value.has_value();
  };
  return {std::move(label), "a number", store, {}, [target] { return Show(*target); }};
}

}  // namespace

std::string DescribeRange(int64_t least, int64_t most) {
  return fmt::format("a whole number from {} to {}", least, most);
}

ArgValue Real(std::string label, float* target) {
  return RealInto(std::move(label), target);
}

ArgValue Real(std::string label, std::optional<float>* target) {
  return RealInto(std::move(label), target);
}

ArgValue Positive(std::string label, std::optional<float>* target) {
  const auto store = [target](std::string_view text) {
    const auto value = ParseFloat(text);
    if (!value || !(*value > 0)) return false;
    *target = *value;
    return true;
  };
  return {std::move(label), "a number above 0", store, {}, [target] { return Show(*target); }};
}

ArgValue Fraction(std::string label, std::optional<float>* target) {
  const auto store = [target](std::string_view text) {
    const auto value = ParseFloat(text);
    if (!value || *value < 0 || *value > 1) return false;
    *target = *value;
    return true;
  };
  return {std::move(label), "a number from 0 to 1", store, {}, [target] { return Show(*target); }};
}

ArgValue NotNegative(std::string label, std::optional<double>* target) {
  const auto store = [target](std::string_view text) {
    const auto value = ParseDouble(text);
    if (!value || *value < 0) return false;
    *target = *value;
    return true;
  };
  return {
      std::move(label), "a number of at least 0", store, {}, [target] { return Show(*target); }};
}

ArgValue File(std::string label, std::filesystem::path* target) {
  return FileInto(std::move(label), target);
}

ArgValue File(std::string label, std::optional<std::filesystem::path>* target) {
  return FileInto(std::move(label), target);
}

ArgValue File(std::string label, std::vector<std::filesystem::path>* target) {
  return {std::move(label), "the name of a file", [=](std::string_view text) {
            if (!text.empty()) target->emplace_back(text);
            return !text.empty();
          }};
}

ArgValue Choice(std::string label, std::string* target, std::vector<std::string_view> choices) {
  return ChoiceInto(std::move(label), target, std::move(choices));
}

ArgValue Choice(std::string label, std::optional<std::string>* target,
                std::vector<std::string_view> choices) {
  return ChoiceInto(std::move(label), target, std::move(choices));
}

}  // namespace candela
