#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace candela {

/// Reads a decimal number: optional sign, digits with an optional point, optional exponent. The
/// whole text must be used and the value must be finite as a float; underflow gives 0. Knows no
/// hexadecimal, nan or inf, and is not influenced by the locale.
std::optional<float> ParseFloat(std::string_view text);

/// The same in double precision, for values that are composed before they are rounded.
std::optional<double> ParseDouble(std::string_view text);

/// True for a number of that grammar that `ParseFloat` refuses because it is too large.
bool IsTooLarge(std::string_view text);

/// Reads a decimal whole number with an optional sign that fits in 64 bits.
std::optional<int64_t> ParseInteger(std::string_view text);

}  // namespace candela
