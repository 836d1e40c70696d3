#include "tests/image_reference/reference_table.h"

#include <fmt/format.h>

#include <cmath>

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

}  // namespace

std::string ReferenceTable() {
  std::string table =
      "| picture | PSNR | pixels that differ | by more than one level | largest, in levels | bar: "
      "differ; by more; PSNR |\n|---|---|---|---|---|---|\n";
  for (const ReferencePicture& picture : ReferencePictures()) table += Row(picture);
  return table;
}

}  // namespace candela::image_reference
