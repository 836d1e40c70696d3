#pragma once

#include <filesystem>

namespace candela {

/// The place of a file behind links and detours; the path as it is when it cannot be followed.
std::filesystem::path PlaceOf(const std::filesystem::path& path);

}  // namespace candela
