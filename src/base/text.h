#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace candela {

/// Control characters, and bytes that are not valid UTF-8, as \xNN: safe to print on a terminal.
std::string EscapeControl(std::string_view text);

/// A word of the input for a message: escaped, cut at 60 characters, in single quotes.
std::string Quote(std::string_view token);

/// True for the second and later bytes of a UTF-8 sequence: places where a text must not be cut.
inline bool IsUtf8Continuation(char byte) {
  return (static_cast<unsigned char>(byte) & 0xC0) == 0x80;
}

/// At most `size` bytes; a longer text ends in "..." and is never cut inside a UTF-8 sequence.
std::string CutTo(size_t size, std::string text);

/// The candidate that `word` probably meant: the same but for upper and lower case, or nearest in
/// edit distance, if near enough to be likely.
std::optional<std::string_view> Nearest(std::string_view word,
                                        std::span<const std::string_view> candidates);

/// " (did you mean 'x'?)", or nothing where no candidate is near.
std::string DidYouMean(std::string_view word, std::span<const std::string_view> candidates);

/// "'a', 'b' or 'c'": quoted words, for messages that say what is accepted.
std::string ListOf(std::span<const std::string_view> words, std::string_view last = "or");

}  // namespace candela
