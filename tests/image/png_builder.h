#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace candela {

// Puts PNG files together piece by piece, so that a test can do one of the pieces wrong.

/// Length, type, content and the right checksum.
std::string PngChunk(std::string_view type, std::string_view content);

std::string PngHeader(uint32_t width, uint32_t height, int depth, int colour, int interlace = 0);

/// A zlib stream.
std::string Deflate(std::string_view bytes);

/// The signature and the given chunks.
std::string PngFile(const std::vector<std::string>& chunks);

/// A whole file with these scanlines, each with its filter in front.
std::string PngOf(const std::string& header, std::string_view scanlines);

/// The filtered form of a scanline, with the filter in front (ISO/IEC 15948, clause 9). `prior` is
/// the scanline above, of the same size, or zeros; `step` the bytes of a pixel, at least 1.
std::string Filtered(int filter, size_t step, std::string_view row, std::string_view prior);

std::string Bytes(std::initializer_list<int> values);

}  // namespace candela
