// candela contact-sheet: pictures side by side on one.

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <vector>

#include "base/files.h"
#include "base/text.h"
#include "candela/commands.h"
#include "driver/arg_parser.h"
#include "driver/console.h"
#include "driver/picture_files.h"
#include "image/contact_sheet.h"
#include "image/size_limit.h"

namespace candela {
namespace {

constexpr const char* kSummary =
    "Puts pictures on a sheet, in rows from left to right. Each is shrunk to fit its cell.";

/// Checks that a sheet with so many pictures fits before any of them is read.
Result<void> CheckSheetSize(const SheetLayout& layout, size_t pictures) {
  const auto count = static_cast<int64_t>(pictures);
  const int64_t columns = std::min<int64_t>(layout.columns, count);
  const int64_t rows = (count + columns - 1) / columns;
  return CheckImageSize(columns * (layout.cell_width + layout.margin) + layout.margin,
                        rows * (layout.cell_height + layout.margin) + layout.margin,
                        3 * sizeof(float));
}

Result<void> MakeSheet(const std::filesystem::path& output,
                       const std::vector<std::filesystem::path>& inputs,
                       const SheetLayout& layout) {
  for (const auto& input : inputs) {
    if (!IsSameFile(input, output)) continue;
    return Error{ErrorCode::kUsage,
                 fmt::format("{} is one of the pictures, which would be overwritten",
                             Quote(output.string()))};
  }
  if (const auto checked = CheckPictureOutput(output); !checked) return checked;
  if (const auto fits = CheckSheetSize(layout, inputs.size()); !fits) return fits;
  std::vector<Image> images;
  for (const auto& input : inputs) {
    Result<Image> image = ReadPicture(input);
    if (!image) return image.error();
    images.push_back(std::move(image).value());
  }
  return WritePicture(output, MakeContactSheet(images, layout));
}

}  // namespace

int RunContactSheetCommand(Words words) {
  std::filesystem::path output;
  std::vector<std::filesystem::path> inputs;
  SheetLayout layout;
  ArgParser parser("candela contact-sheet", kSummary, ArgStyle::kGnu);
  parser.Positional(File("OUT", &output), "the sheet: .png, .jpg, .exr, .hdr or .pfm");
  parser.PositionalList(File("IN", &inputs), "pictures");
  parser.Group("Layout");
  parser.Option("columns", {Whole("N", &layout.columns, 1, 1000)},
                fmt::format("pictures in a row (default {})", layout.columns));
  parser.Option(
      "cell", {Whole("W", &layout.cell_width, 1, 16384), Whole("H", &layout.cell_height, 1, 16384)},
      fmt::format("pixels of a cell (default {} {})", layout.cell_width, layout.cell_height));
  parser.Option("margin", {Whole("N", &layout.margin, 0, 1000)},
                fmt::format("pixels around each cell (default {})", layout.margin));
  parser.Example("contact.png out/0[1-7].png", "all course pictures");
  if (const auto status = ReadCommandLine(parser, words)) return *status;

  const auto made = MakeSheet(output, inputs, layout);
  return made ? 0 : PrintError(parser.program(), made.error());
}

}  // namespace candela
