#include "base/number.h"

#include <charconv>
#include <cmath>
#include <limits>
#include <system_error>

namespace candela {
namespace {

bool IsDigit(char c) {
  return c >= '0' && c <= '9';
}

/// Takes a leading '+' off; `std::from_chars` knows only '-'. Empty when no number can follow.
std::string_view WithoutPlus(std::string_view text) {
  if (text.empty() || text[0] != '+') return text;
  text.remove_prefix(1);
  return !text.empty() && text[0] == '-' ? std::string_view() : text;
}

/// A number that overflowed or underflowed has the grammar of one; its exponent tells which it was.
/// Called only for such texts, so simplicity beats speed.
bool IsUnderflow(std::string_view text) {
  // Position of the leading digit relative to the point, plus the exponent: negative is tiny.
  int64_t exponent = 0;
  const size_t e = text.find_first_of("eE");
  const std::string_view mantissa = text.substr(0, e);
  if (e != std::string_view::npos) {
    std::string_view digits = WithoutPlus(text.substr(e + 1));
    const bool negative = !digits.empty() && digits[0] == '-';
    const auto parsed = ParseInteger(digits);
    exponent = parsed ? *parsed
                      : (negative ? std::numeric_limits<int64_t>::min() / 2
                                  : std::numeric_limits<int64_t>::max() / 2);
  }
  int64_t leading = 0;
  bool before_point = true, seen = false;
  for (const char c : mantissa) {
    if (c == '.') {
      before_point = false;
    } else if (IsDigit(c)) {
      seen = seen || c != '0';
      if (before_point && seen) ++leading;
      if (!before_point && !seen) --leading;
    }
  }
  return !seen || leading < -exponent;
}

/// What a text says: no number, a finite one, or one that is too large for a finite T.
template <class T>
struct Real {
  enum { kNone, kFinite, kTooLarge } kind = kNone;
  T value = 0;
};

template <class T>
Real<T> ReadReal(std::string_view text) {
  text = WithoutPlus(text);
  if (text.empty()) return {};
  // Reject the words and hexadecimal forms that from_chars would take.
  const size_t first = text[0] == '-' ? 1 : 0;
  if (first == text.size() || !(IsDigit(text[first]) || text[first] == '.')) return {};

  T value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (end != text.data() + text.size() || error == std::errc::invalid_argument) return {};
  if (error != std::errc::result_out_of_range) return {Real<T>::kFinite, value};
  return {IsUnderflow(text) ? Real<T>::kFinite : Real<T>::kTooLarge, T{0}};
}

}  // namespace

std::optional<float> ParseFloat(std::string_view text) {
  const auto real = ReadReal<float>(text);
  if (real.kind != Real<float>::kFinite) return std::nullopt;
  return real.value;
}

std::optional<double> ParseDouble(std::string_view text) {
  const auto real = ReadReal<double>(text);
  const bool fits = std::isfinite(static_cast<float>(real.value));
  if (real.kind != Real<double>::kFinite || !fits) return std::nullopt;
  return real.value;
}

bool IsTooLarge(std::string_view text) {
  return ReadReal<float>(text).kind == Real<float>::kTooLarge;
}

std::optional<int64_t> ParseInteger(std::string_view text) {
  text = WithoutPlus(text);
  int64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (text.empty() || error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

}  // namespace candela
