#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostics.h"
#include "lights/ies_file.h"
#include "lights/ies_words.h"

namespace candela {

/// Reads one photometric text; see `ParseIes`. Stops at the first error, since all that follows is
/// numbers that mean what their count says.
class IesParser {
 public:
  IesParser(std::shared_ptr<const std::string> file, std::string_view text,
            Diagnostics* diagnostics);

  /// To be called once.
  std::optional<IesFile> Parse();

 private:
  /// More angles than that have no lamp, nor more values in all.
  static constexpr int64_t kMostAngles = 10000, kMostValues = 4000000;

  using Word = IesWords::Word;
  struct Counts {
    size_t vertical, horizontal;
  };

  bool HasNul();
  /// Finds out which edition it is, and goes behind the line that begins with TILT=.
  bool SkipLabels();
  bool ReadTilt();
  /// The numbers between the tilt and the angles; nothing when they are wrong.
  std::optional<Counts> ReadLamp();
  bool ReadVertical(size_t count);
  bool ReadHorizontal(size_t count);
  bool ReadCandela();
  /// Repeats what a symmetric lamp is not told about, so that the horizontal angles go from 0 to
  /// 360.
  void GoAround();
  /// Adds the mirror image of all horizontal angles about the last one.
  void MirrorAtLast();

  std::optional<float> Number(const char* what);
  std::optional<float> NonNegative(const char* what);
  std::optional<float> Positive(const char* what);
  std::optional<int64_t> WholeNumber(const char* what, int64_t least, int64_t most);
  /// Numbers that grow strictly.
  bool Ascending(const char* what, size_t count, std::vector<float>* list);
  bool Fail(const Word& word, std::string text);

  std::shared_ptr<const std::string> file_;
  std::string_view text_;
  IesWords words_;
  Diagnostics& diagnostics_;
  Word last_{};  ///< The one that was read as a number.

  bool is_of_1995_ = false;  ///< Or newer.
  std::vector<float> tilt_angles_, tilt_factors_;
  float factor_ = 1;  ///< Of all intensities.
  IesProfile::Table table_;
};

}  // namespace candela
