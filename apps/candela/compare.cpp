// candela compare: how far two pictures are apart.

#include <fmt/format.h>

#include <array>
#include <optional>
#include <string>

#include "base/files.h"
#include "base/text.h"
#include "candela/commands.h"
#include "driver/arg_parser.h"
#include "driver/console.h"
#include "driver/picture_files.h"
#include "image/compare.h"

namespace candela {
namespace {

constexpr const char* kSummary =
    "Compares two pictures of the same size and prints how far they are apart. With thresholds, "
    "the "
    "exit status is 6 when they are further apart than any of them allows.";

/// The exit status for pictures that differ beyond a threshold.
constexpr int kBeyondThreshold = 6;

struct Thresholds {
  std::optional<double> min_psnr, max_difference;
  std::optional<int64_t> max_pixels;
};

std::string Facts(const ImageDifference& difference) {
  const double share =
      100.0 * static_cast<double>(difference.differing) / static_cast<double>(difference.pixels);
  // An infinite number of decibels would be printed as "inf"; say what it means.
  const std::string psnr =
      difference.mse == 0 ? "equal" : fmt::format("{:.2f} dB", difference.psnr);
  return fmt::format(
      "PSNR        {}\n"
      "MSE         {:.6g}\n"
      "differing   {} of {} pixels ({:.4g}%), {} by more than 1/255\n"
      "largest     {:.6g} ({:.4g} levels of 1/255)\n",
      psnr, difference.mse, difference.differing, difference.pixels, share,
      difference.beyond_one_level, difference.largest, difference.LargestInLevels());
}

/// What is beyond the thresholds, one line each; empty when nothing is.
std::string Verdict(const ImageDifference& difference, const Thresholds& allowed) {
  std::string verdict;
  // Written so that a NaN is beyond any threshold.
  if (allowed.min_psnr && !(difference.psnr >= *allowed.min_psnr)) {
    verdict += fmt::format("beyond: PSNR is below {:.6g} dB\n", *allowed.min_psnr);
  }
  if (allowed.max_pixels && difference.differing > *allowed.max_pixels) {
    verdict += fmt::format("beyond: more than {} pixels differ\n", *allowed.max_pixels);
  }
  constexpr double kSlack = 1 + ImageDifference::kLevelSlack;
  if (allowed.max_difference &&
      !(difference.LargestInLevels() <= *allowed.max_difference * kSlack)) {
    verdict += fmt::format("beyond: a channel differs by more than {:.6g} levels\n",
                           *allowed.max_difference);
  }
  return verdict;
}

Result<void> CheckDifferencePath(const std::filesystem::path& path, const std::filesystem::path& a,
                                 const std::filesystem::path& b) {
  if (IsSameFile(path, a) || IsSameFile(path, b)) {
    return UsageError(
        fmt::format("--difference: {} is one of the pictures to compare", Quote(path.string())));
  }
  return CheckPictureOutput(path);
}

}  // namespace

int RunCompareCommand(Words words) {
  std::filesystem::path a_path, b_path;
  std::optional<std::filesystem::path> difference_path;
  float gain = 1;
  Thresholds allowed;
  ArgParser parser("candela compare", kSummary, ArgStyle::kGnu);
  parser.Positional(File("A", &a_path), "a picture: .png, .jpg, .exr, .hdr or .pfm");
  parser.Positional(File("B", &b_path), "another one");
  parser.Group("Thresholds");
  parser.Option("min-psnr", {NotNegative("DB", &allowed.min_psnr)}, "least PSNR in decibels");
  parser.Option("max-pixels", {Whole("N", &allowed.max_pixels, 0)},
                "most pixels that may differ at all");
  parser.Option("max-difference", {NotNegative("LEVELS", &allowed.max_difference)},
                "largest difference of a channel, in levels of 1/255");
  parser.Group("Picture of the differences");
  parser.Option("difference", {File("FILE", &difference_path)}, "write it");
  parser.Option("gain", {Real("X", &gain)}, "multiply it (default 1)");
  parser.Example("01.png expected.png --min-psnr 45 --max-pixels 40", "a test in a script");
  parser.Example("a.exr b.exr --difference d.png --gain 10", "where small differences are");
  if (const auto status = ReadCommandLine(parser, words)) return *status;

  const auto fail = [&](const Error& error) { return PrintError(parser.program(), error); };
  if (parser.Has("gain") && !difference_path) {
    return fail(UsageError("--gain goes with --difference only"));
  }
  if (difference_path) {
    const auto checked = CheckDifferencePath(*difference_path, a_path, b_path);
    if (!checked) return fail(checked.error());
  }
  const Result<Image> a = ReadPicture(a_path);
  if (!a) return fail(a.error());
  const Result<Image> b = ReadPicture(b_path);
  if (!b) return fail(b.error());
  const Result<ImageDifference> difference = CompareImages(*a, *b);
  if (!difference) return fail(difference.error());
  if (difference_path) {
    const Result<Image> picture = DifferencePicture(*a, *b, gain);
    if (!picture) return fail(picture.error());
    if (const auto written = WritePicture(*difference_path, *picture); !written) {
      return fail(written.error());
    }
  }
  const std::string verdict = Verdict(*difference, allowed);
  const int printed = PrintResult(parser.program(), Facts(*difference) + verdict);
  if (printed != 0) return printed;
  return verdict.empty() ? 0 : kBeyondThreshold;
}

}  // namespace candela
