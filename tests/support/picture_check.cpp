#include "tests/support/picture_check.h"

#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>
#include <span>
#include <string_view>

#include "base/files.h"
#include "image/compare.h"
#include "image/image_file.h"

namespace candela::testing_support {
namespace {

/// The line about one file.
std::string Store(const std::filesystem::path& path, const Result<Image>& image) {
  if (!image) return fmt::format("{}: {}\n", path.string(), image.error().message);
  const Result<std::string> bytes = EncodeImage(*image, ImageFormat::kPng);
  if (!bytes) return fmt::format("{}: {}\n", path.string(), bytes.error().message);
  const Result<void> written = WriteFileAtomically(path, std::as_bytes(std::span(*bytes)));
  return fmt::format("{}{}{}\n", path.string(), written ? "" : ": ",
                     written ? "" : written.error().message);
}

}  // namespace

bool IsUpdate() {
  const char* value = std::getenv("CANDELA_UPDATE");
  return value != nullptr && std::string_view(value) == "1";
}

std::string StoreForInspection(const std::string& name, const Image& ours, const Image& reference) {
  const std::filesystem::path folder = ExecutableFolder() / "failed";
  std::error_code ignored;  // A folder that is missing shows in the lines.
  std::filesystem::create_directories(folder, ignored);
  constexpr float kGain = 10;
  return "see\n" + Store(folder / (name + ".ours.png"), ours) +
         Store(folder / (name + ".reference.png"), reference) +
         Store(folder / (name + ".difference.png"), DifferencePicture(ours, reference, kGain));
}

}  // namespace candela::testing_support
