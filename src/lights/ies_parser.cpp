#include "lights/ies_parser.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/number.h"
#include "base/text.h"

namespace candela {
namespace {

/// Brighter than any lamp; sums of such intensities stay finite.
constexpr float kMostCandela = 1e12f;

std::string_view WithoutByteOrderMark(std::string_view text) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  return text;
}

}  // namespace

IesParser::IesParser(std::shared_ptr<const std::string> file, std::string_view text,
                     Diagnostics* diagnostics)
    : file_(std::move(file)),
      text_(WithoutByteOrderMark(text)),
      words_(text_),
      diagnostics_(*diagnostics) {}

std::optional<IesFile> IesParser::Parse() {
  if (HasNul() || !SkipLabels()) return std::nullopt;
  const std::optional<Counts> counts = ReadLamp();
  if (!counts || !ReadVertical(counts->vertical) || !ReadHorizontal(counts->horizontal) ||
      !ReadCandela()) {
    return std::nullopt;
  }
  if (const Word word = words_.NextWord(); !word.text.empty()) {
    diagnostics_.Warning({file_, word.line, word.column},
                         fmt::format("what follows the last of the candela values is left out: {}",
                                     Quote(word.text)));
  }
  GoAround();
  return IesFile{IesProfile(std::move(table_)), std::move(tilt_angles_), std::move(tilt_factors_)};
}

bool IesParser::Fail(const Word& word, std::string text) {
  diagnostics_.Error({file_, word.line, word.column}, std::move(text));
  return false;
}

bool IesParser::HasNul() {
  if (text_.find('\0') == std::string_view::npos) return false;
  IesWords words(text_);
  Word line = words.NextLine();
  while (line.text.find('\0') == std::string_view::npos) line = words.NextLine();
  const auto column = static_cast<uint32_t>(line.text.find('\0'));
  Fail({{}, line.line, line.column + column}, "a text file is due, found a NUL byte");
  return true;
}

// The first line names the edition, but for that of 1986, which begins with labels. Newer ones mark
// their labels by brackets; whatever they are, what counts begins at TILT=.
bool IesParser::SkipLabels() {
  constexpr std::string_view kTilt = "TILT=";
  bool is_first = true;
  while (!words_.IsAtEnd()) {
    const Word line = words_.NextLine();
    if (is_first) {
      is_of_1995_ = line.text.starts_with("IESNA:") || line.text.starts_with("IES:");
      is_first = false;
    }
    if (!line.text.starts_with(kTilt)) continue;
    const std::string_view tilt = line.text.substr(kTilt.size());
    if (tilt == "NONE") return true;
    if (tilt == "INCLUDE") return ReadTilt();
    return Fail({tilt, line.line, line.column + static_cast<uint32_t>(kTilt.size())},
                fmt::format("'TILT=' expects 'NONE', or 'INCLUDE' with the table in this file, "
                            "found {}",
                            Quote(tilt)));
  }
  diagnostics_.Error({file_}, "this is no photometric file: no line begins with 'TILT='");
  return false;
}

bool IesParser::ReadTilt() {
  // How the lamp lies in its housing; the table holds for it as it is.
  if (!WholeNumber("the lamp's place in the luminaire", 1, 3)) return false;
  const auto count = WholeNumber("the number of tilt angles", 1, kMostAngles);
  if (!count || !Ascending("a tilt angle", static_cast<size_t>(*count), &tilt_angles_)) {
    return false;
  }
  for (int64_t i = 0; i < *count; ++i) {
    const auto factor = NonNegative("a factor for a tilt angle");
    if (!factor) return false;
    tilt_factors_.push_back(*factor);
  }
  return true;
}

std::optional<IesParser::Counts> IesParser::ReadLamp() {
  if (!Number("the number of lamps") || !Number("the lumens of a lamp")) return std::nullopt;
  const auto multiplier = Positive("the multiplier of the candela values");
  if (!multiplier) return std::nullopt;
  const auto vertical = WholeNumber("the number of vertical angles", 2, kMostAngles);
  if (!vertical) return std::nullopt;
  const auto horizontal = WholeNumber("the number of horizontal angles", 1, kMostAngles);
  if (!horizontal) return std::nullopt;
  if (*vertical * *horizontal > kMostValues) {
    Fail(last_,
         fmt::format("{} times {} values are more than {}", *vertical, *horizontal, kMostValues));
    return std::nullopt;
  }
  const auto type = WholeNumber("the photometric type", 1, 3);
  if (!type) return std::nullopt;
  if (*type != 1) {
    Fail(last_, fmt::format("the photometric type is {}; only 1, type C, is known",
                            *type == 2 ? "2, type B" : "3, type A"));
    return std::nullopt;
  }
  if (!WholeNumber("the unit of length, 1 for feet or 2 for metres", 1, 2)) return std::nullopt;
  for (const char* side : {"the width", "the length", "the height"}) {
    if (!Number(side)) return std::nullopt;
  }
  const auto ballast = Positive("the ballast factor");
  if (!ballast) return std::nullopt;
  // From 1995 on this number has no meaning for the light.
  const auto lamp = is_of_1995_ ? Number("the number behind the ballast factor")
                                : Positive("the ballast-lamp photometric factor");
  if (!lamp || !Number("the input watts")) return std::nullopt;
  factor_ = *multiplier * *ballast * (is_of_1995_ ? 1.0f : *lamp);
  return Counts{static_cast<size_t>(*vertical), static_cast<size_t>(*horizontal)};
}

bool IesParser::ReadVertical(size_t count) {
  if (!Ascending("a vertical angle", count, &table_.vertical)) return false;
  const float first = table_.vertical.front(), last = table_.vertical.back();
  if ((first == 0 && (last == 90 || last == 180)) || (first == 90 && last == 180)) return true;
  return Fail(last_, fmt::format("vertical angles go from 0 to 90, from 90 to 180 or from 0 to "
                                 "180, found {} to {}",
                                 first, last));
}

bool IesParser::ReadHorizontal(size_t count) {
  if (!Ascending("a horizontal angle", count, &table_.horizontal)) return false;
  const float first = table_.horizontal.front(), last = table_.horizontal.back();
  const bool is_half =
      (first == 0 && (last == 0 || last == 90 || last == 180)) || (first == 90 && last == 270);
  const bool is_whole = first == 0 && last > 180 && last <= 360;
  if (is_half || is_whole) return true;
  return Fail(last_, fmt::format("horizontal angles go from 0 to 0, 90, 180 or 360, or from 90 to "
                                 "270, found {} to {}",
                                 first, last));
}

bool IesParser::ReadCandela() {
  const size_t count = table_.vertical.size() * table_.horizontal.size();
  for (size_t i = 0; i < count; ++i) {
    const auto value = NonNegative("a candela value");
    if (!value) return false;
    const float candela = *value * factor_;
    if (!(candela <= kMostCandela)) {
      return Fail(last_, fmt::format("a candela value is at most {:g} with its factors, found {}",
                                     kMostCandela, Quote(last_.text)));
    }
    table_.candela.push_back(candela);
  }
  return true;
}

void IesParser::GoAround() {
  std::vector<float>& horizontal = table_.horizontal;
  const size_t rows = table_.vertical.size();
  if (horizontal.back() == 0) {
    // The same all around.
    horizontal.push_back(360);
    const std::vector<float> column = table_.candela;
    table_.candela.insert(table_.candela.end(), column.begin(), column.end());
    return;
  }
  if (horizontal.front() == 90) {
    table_.first_horizontal = 90;
    for (float& angle : horizontal) angle -= 90;
  }
  if (horizontal.back() == 90) MirrorAtLast();
  if (horizontal.back() == 180) MirrorAtLast();
  if (horizontal.back() < 360) {
    horizontal.push_back(360);
    const std::vector<float> first(table_.candela.begin(),
                                   table_.candela.begin() + static_cast<std::ptrdiff_t>(rows));
    table_.candela.insert(table_.candela.end(), first.begin(), first.end());
  }
}

void IesParser::MirrorAtLast() {
  const size_t count = table_.horizontal.size(), rows = table_.vertical.size();
  const float last = table_.horizontal.back();
  for (size_t i = count - 1; i-- > 0;) {
    table_.horizontal.push_back(2 * last - table_.horizontal[i]);
    for (size_t row = 0; row < rows; ++row) {
      const float candela = table_.candela[i * rows + row];
      table_.candela.push_back(candela);
    }
  }
}

std::optional<float> IesParser::Number(const char* what) {
  const Word word = words_.NextWord();
  last_ = word;
  if (word.text.empty()) {
    Fail(word, fmt::format("the file ends where {} is due", what));
    return std::nullopt;
  }
  const auto number = ParseFloat(word.text);
  if (!number) {
    Fail(word, fmt::format("{} is due, found {}{}", what, Quote(word.text),
                           IsTooLarge(word.text) ? ", which is too large" : ""));
  }
  return number;
}

std::optional<float> IesParser::NonNegative(const char* what) {
  const auto number = Number(what);
  if (!number || *number >= 0) return number;
  Fail(last_, fmt::format("{} is not negative, found {}", what, Quote(last_.text)));
  return std::nullopt;
}

std::optional<float> IesParser::Positive(const char* what) {
  const auto number = Number(what);
  if (!number || *number > 0) return number;
  Fail(last_, fmt::format("{} is above 0, found {}", what, Quote(last_.text)));
  return std::nullopt;
}

std::optional<int64_t> IesParser::WholeNumber(const char* what, int64_t least, int64_t most) {
  if (!Number(what)) return std::nullopt;
  const auto number = ParseInteger(last_.text);
  if (number && *number >= least && *number <= most) return number;
  Fail(last_, fmt::format("{} is a whole number from {} to {}, found {}", what, least, most,
                          Quote(last_.text)));
  return std::nullopt;
}

bool IesParser::Ascending(const char* what, size_t count, std::vector<float>* list) {
  for (size_t i = 0; i < count; ++i) {
    const auto number = Number(what);
    if (!number) return false;
    // Nearer ones would be as good as two values for one angle.
    constexpr float kLeastStep = 1e-3f;
    if (!list->empty() && !(*number - list->back() >= kLeastStep)) {
      return Fail(last_,
                  fmt::format("{} is at least {} above the one before it, found {} behind {}", what,
                              kLeastStep, Quote(last_.text), list->back()));
    }
    list->push_back(*number);
  }
  return true;
}

}  // namespace candela
