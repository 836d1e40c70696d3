#pragma once

#include <filesystem>
#include <string>

#include "base/result.h"
#include "image/image_file.h"

namespace candela {

/// The same error with a message that names the path.
Error WithPath(const std::filesystem::path& path, const Error& error);

/// Checks that a file can be written to `path`. The message of an error names the path.
Result<void> CheckOutput(const std::filesystem::path& path);

/// Checks that a picture can be written to `path`: its name tells a format, its place is writable.
Result<void> CheckPictureOutput(const std::filesystem::path& path);

/// Writes bytes to `path` atomically. The message of an error names the path.
Result<void> WriteOutput(const std::filesystem::path& path, const std::string& bytes);

/// Encodes a picture in the format of the name and writes it.
Result<void> WritePicture(const std::filesystem::path& path, const Image& image);

/// Reads a picture and prints warnings about it on stderr. The message of an error names the path.
Result<Image> ReadPicture(const std::filesystem::path& path);

}  // namespace candela
