#include "driver/picture_files.h"

#include <fmt/format.h>

#include <span>
#include <string>
#include <vector>

#include "base/files.h"
#include "base/text.h"
#include "driver/console.h"

namespace candela {

Error WithPath(const std::filesystem::path& path, const Error& error) {
  return {error.code, fmt::format("{}: {}", Quote(path.string()), error.message)};
}

Result<void> CheckOutput(const std::filesystem::path& path) {
  if (const auto writable = CheckWritable(path); !writable) return WithPath(path, writable.error());
  return {};
}

Result<void> CheckPictureOutput(const std::filesystem::path& path) {
  if (!FormatOf(path)) {
    return Error{
        ErrorCode::kUsage,
        fmt::format("{}: the name of a picture has to end in .png, .jpg, .exr, .hdr or .pfm",
                    Quote(path.string()))};
  }
  return CheckOutput(path);
}

Result<void> WriteOutput(const std::filesystem::path& path, const std::string& bytes) {
  const auto written = WriteFileAtomically(path, std::as_bytes(std::span(bytes)));
  if (!written) return WithPath(path, written.error());
  return {};
}

Result<void> WritePicture(const std::filesystem::path& path, const Image& image) {
  const auto bytes = EncodeImage(image, *FormatOf(path));
  if (!bytes) return WithPath(path, bytes.error());
  return WriteOutput(path, *bytes);
}

Result<Image> ReadPicture(const std::filesystem::path& path) {
  std::vector<std::string> warnings;
  Result<Image> image = ReadImage(path, &warnings);
  for (const std::string& warning : warnings) PrintWarning(path.string(), warning);
  if (!image) return WithPath(path, image.error());
  return image;
}

}  // namespace candela
