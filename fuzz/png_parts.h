#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace candela::fuzz {

struct PngPart {
  std::string type;  ///< Four bytes.
  std::string content;
};

/// The chunks of anything that begins like a PNG file, as far as they go. Wrong lengths are cut to
/// what is there; checksums are not looked at.
std::vector<PngPart> SplitPng(std::string_view bytes);

/// The file made of these chunks, with lengths and checksums that are right.
std::string JoinPng(const std::vector<PngPart>& parts);

/// The beginning of what the IDAT chunks expand to, at most `most` bytes.
std::string ExpandData(const std::vector<PngPart>& parts, size_t most);

/// A zlib stream of `data`.
std::string Compress(std::string_view data);

}  // namespace candela::fuzz
