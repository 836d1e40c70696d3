#include "tests/image_reference/reference_table.h"

#include <fmt/format.h>

#include <cmath>
#include <iterator>

#include "tests/image_reference/reference_pictures.h"

namespace candela::image_reference {
namespace {

std::string DescribeBar(const Bar& bar) {
  std::string beyond = "none";
  if (bar.beyond_percent > 0) beyond = fmt::format("{} %", bar.beyond_percent);
  if (bar.beyond_pixels > 0) beyond = fmt::format("{} px or {}", bar.beyond_pixels, beyond);
  return fmt::format("{} %; {}; {} dB", bar.differing_percent, beyond, bar.least_psnr);
}

std::string Row(const ReferencePicture& picture) {
  const Comparison& comparison = CompareWithReference(picture);
  const ImageDifference& difference = comparison.difference;
  const std::string psnr =
      std::isinf(difference.psnr) ? "equal" : fmt::format("{:.1f} dB", difference.psnr);
  return fmt::format("| {} | {} | {} ({:.4f} %) | {} | {:.0f} | {} |\n", picture.Name(), psnr,
                     difference.differing, comparison.DifferingPercent(),
                     difference.beyond_one_level, difference.LargestInLevels(),
                     DescribeBar(picture.bar()));
}

/// Where the part begins and ends.
struct Range {
  size_t begin, end;
};
Result<Range> FindPart(std::string_view document, std::string_view name) {
  const std::string first = fmt::format("<!-- begin: {} -->\n", name);
  const std::string last = fmt::format("<!-- end: {} -->\n", name);
  const size_t begin = document.find(first);
  const size_t end = document.find(last);
  if (begin == document.npos || end == document.npos || end < begin) {
    return Error{ErrorCode::kInput, fmt::format("there is no part '{}'", name)};
  }
  return Range{begin + first.size(), end};
}

}  // namespace

std::string ReferenceTable() {
  std::string table =
      "| picture | PSNR | pixels that differ | by more than one level | largest, in levels | bar: "
      "differ; by more; PSNR |\n|---|---|---|---|---|---|\n";
  for (const ReferencePicture& picture : ReferencePictures()) table += Row(picture);
  return table;
}

Result<std::string> GeneratedPart(std::string_view document, std::string_view name) {
  const Result<Range> range = FindPart(document, name);
  if (!range) return range.error();
  return std::string(document.substr(range->begin, range->end - range->begin));
}

Result<std::string> ReplaceGeneratedPart(std::string_view document, std::string_view name,
                                         std::string_view part) {
  const Result<Range> range = FindPart(document, name);
  if (!range) return range.error();
  return fmt::format("{}{}{}", document.substr(0, range->begin), part, document.substr(range->end));
}

}  // namespace candela::image_reference
