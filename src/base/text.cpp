#include "base/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace candela {
namespace {

constexpr size_t kLongestToken = 60;

/// Length of the valid UTF-8 sequence at `at`; 0 when there is none.
size_t Utf8Length(std::string_view text, size_t at) {
  const auto byte = [&](size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char lead = byte(at);
  size_t length = 0;
  if (lead < 0x80) return 1;
  if (lead >= 0xC2 && lead <= 0xDF) length = 2;
  if (lead >= 0xE0 && lead <= 0xEF) length = 3;
  if (lead >= 0xF0 && lead <= 0xF4) length = 4;
  if (length == 0 || at + length > text.size()) return 0;
  for (size_t i = 1; i < length; ++i) {
    if (!IsUtf8Continuation(text[at + i])) return 0;
  }
  // Overlong forms, surrogates and values past U+10FFFF; C1 controls count as not printable.
  const unsigned char second = byte(at + 1);
  if (lead == 0xE0 && second < 0xA0) return 0;
  if (lead == 0xED && second > 0x9F) return 0;
  if (lead == 0xF0 && second < 0x90) return 0;
  if (lead == 0xF4 && second > 0x8F) return 0;
  if (lead == 0xC2 && second < 0xA0) return 0;
  return length;
}

bool IsSameButForCase(std::string_view a, std::string_view b) {
  const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; };
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [&](char x, char y) { return lower(x) == lower(y); });
}

/// Edit distance where a swap of neighbours counts one (optimal string alignment).
size_t Distance(std::string_view a, std::string_view b) {
  std::vector<size_t> before(b.size() + 1), last(b.size() + 1), now(b.size() + 1);
  for (size_t j = 0; j <= b.size(); ++j) last[j] = j;
  for (size_t i = 1; i <= a.size(); ++i) {
    now[0] = i;
    for (size_t j = 1; j <= b.size(); ++j) {
      const size_t change = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      now[j] = std::min({last[j] + 1, now[j - 1] + 1, change});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) now[j] = std::min(now[j], before[j - 2] + 1);
    }
    before.swap(last);
    last.swap(now);
  }
  return last[b.size()];
}

}  // namespace

std::string EscapeControl(std::string_view text) {
  std::string escaped;
  escaped.reserve(text.size());
  for (size_t i = 0; i < text.size();) {
    const auto byte = static_cast<unsigned char>(text[i]);
    const size_t length = byte < 0x20 || byte == 0x7F ? 0 : Utf8Length(text, i);
    if (length == 0) {
      escaped += fmt::format("\\x{:02x}", byte);
      ++i;
    } else {
      escaped.append(text, i, length);
      i += length;
    }
  }
  return escaped;
}

std::string CutTo(size_t size, std::string text) {
  if (text.size() <= size) return text;
  size_t end = size < 3 ? 0 : size - 3;
  while (end > 0 && IsUtf8Continuation(text[end])) --end;
  text.resize(end);
  return text + "...";
}

std::string Quote(std::string_view token) {
  // Escaping only lengthens, so a first cut keeps a token of a megabyte cheap.
  return "'" + CutTo(kLongestToken, EscapeControl(token.substr(0, kLongestToken + 4))) + "'";
}

std::optional<std::string_view> Nearest(std::string_view word,
                                        std::span<const std::string_view> candidates) {
  if (word.size() > kLongestToken) return std::nullopt;
  std::optional<std::string_view> nearest;
  size_t least = word.size() <= 2 ? 1 : std::min<size_t>(3, word.size() / 3 + 1);
  for (const std::string_view candidate : candidates) {
    if (IsSameButForCase(word, candidate)) return candidate;
    const size_t longer = std::max(word.size(), candidate.size());
    if (longer - std::min(word.size(), candidate.size()) > least) continue;
    const size_t distance = Distance(word, candidate);
    if (distance < least || (distance == least && !nearest && distance < candidate.size())) {
      least = distance;
      nearest = candidate;
    }
  }
  return nearest;
}

std::string DidYouMean(std::string_view word, std::span<const std::string_view> candidates) {
  const auto nearest = Nearest(word, candidates);
  return nearest ? fmt::format(" (did you mean '{}'?)", *nearest) : std::string();
}

std::string ListOf(std::span<const std::string_view> words, std::string_view last) {
  std::string list;
  for (size_t i = 0; i < words.size(); ++i) {
    if (i > 0) list += i + 1 == words.size() ? fmt::format(" {} ", last) : ", ";
    list += fmt::format("'{}'", words[i]);
  }
  return list;
}

}  // namespace candela
