#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/number.h"

namespace candela {

/// One word that follows an option, or stands for itself: what it may be and where it goes.
struct ArgValue {
  std::string label;    ///< For the help: "W", "FILE".
  std::string expects;  ///< For messages: "a whole number from 1 to 16".
  /// Converts the word and stores it; false, and nothing stored, when it is not what is expected.
  std::function<bool(std::string_view)> store;
  std::vector<std::string_view> choices = {};  ///< The words that are accepted, if few.
  /// The word that would store what the target holds; empty when it holds nothing.
  std::function<std::string()> show = {};
};

/// The largest side, count or number of bounces.
constexpr int64_t kLargestCount = 2147483647;

/// "a whole number from 1 to 16".
std::string DescribeRange(int64_t least, int64_t most);

/// A whole number from `least` to `most`, which both fit in the target. A target may also be an
/// `std::optional` number.
template <class Target>
ArgValue Whole(std::string label, Target* target, int64_t least, int64_t most = kLargestCount) {
  constexpr bool kIsOptional = requires {
    typename Target::value_type;
  };
  const auto store = [=](std::string_view text) {
    const auto value = ParseInteger(text);
    if (!value || *value < least || *value > most) return false;
    if constexpr (kIsOptional) {
      *target = static_cast<typename Target::value_type>(*value);
    } else {
      *target = static_cast<Target>(*value);
    }
    return true;
  };
  const auto show = [=] {
    if constexpr (kIsOptional) {
      return *target ? std::to_string(**target) : std::string();
    } else {
      return std::to_string(*target);
    }
  };
  return {std::move(label), DescribeRange(least, most), store, {}, show};
}

/// A number that is finite as a float.
ArgValue Real(std::string label, float* target);
ArgValue Real(std::string label, std::optional<float>* target);
/// A number above 0 that is finite as a float.
ArgValue Positive(std::string label, std::optional<float>* target);
/// A number from 0 to 1.
ArgValue Fraction(std::string label, std::optional<float>* target);
/// A number of at least 0.
ArgValue NotNegative(std::string label, std::optional<double>* target);

/// A path; anything but the empty word.
ArgValue File(std::string label, std::filesystem::path* target);
ArgValue File(std::string label, std::optional<std::filesystem::path>* target);
/// Appends to the list.
ArgValue File(std::string label, std::vector<std::filesystem::path>* target);

/// One of a list of words.
ArgValue Choice(std::string label, std::string* target, std::vector<std::string_view> choices);
/// One of a list of words; the value goes to the optional target.
ArgValue Choice(std::string label, std::optional<std::string>* target,
                std::vector<std::string_view> choices);

}  // namespace candela
