// The number readers: whatever they accept is a finite decimal number, and agrees with the C
// library.
#include "base/number.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>

#include "base/check.h"

namespace {

bool IsDecimal(const std::string& text) {
  return std::all_of(text.begin(), text.end(), [](char c) {
    return (c >= '0' && c <= '9') || c == '+' || c == '-' || c == '.' || c == 'e' || c == 'E';
  });
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  char* end = nullptr;

  if (const auto value = candela::ParseFloat(text)) {
    CHECK(std::isfinite(*value) && IsDecimal(text));
    const float expected = std::strtof(text.c_str(), &end);
    CHECK(end == text.c_str() + text.size());
    CHECK(*value == expected || (*value == 0.0f && std::fabs(expected) < 1.2e-38f));
  }
  if (const auto value = candela::ParseDouble(text)) {
    CHECK(std::isfinite(static_cast<float>(*value)) && IsDecimal(text));
    CHECK(candela::ParseFloat(text).has_value());
  }
  if (const auto value = candela::ParseInteger(text)) {
    CHECK(IsDecimal(text) && *value == std::strtoll(text.c_str(), &end, 10));
    CHECK(end == text.c_str() + text.size());
  }
  return 0;
}
