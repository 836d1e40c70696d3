#include "tests/image/png_builder.h"

#include <zlib.h>

#include <cstdlib>
#include <stdexcept>

namespace candela {
namespace {

std::string BigEndian(uint32_t value) {
  return Bytes({static_cast<int>(value >> 24), static_cast<int>(value >> 16 & 255),
                static_cast<int>(value >> 8 & 255), static_cast<int>(value & 255)});
}

const Bytef* Data(std::string_view bytes) {
  return reinterpret_cast<const Bytef*>(bytes.data());
}

}  // namespace

std::string Bytes(std::initializer_list<int> values) {
  std::string result;
  for (const int value : values) result.push_back(static_cast<char>(value));
  return result;
}

std::string PngChunk(std::string_view type, std::string_view content) {
  const std::string body = std::string(type) + std::string(content);
  const uLong sum = crc32(0, Data(body), static_cast<uInt>(body.size()));
  return BigEndian(static_cast<uint32_t>(content.size())) + body +
         BigEndian(static_cast<uint32_t>(sum));
}

std::string PngHeader(uint32_t width, uint32_t height, int depth, int colour, int interlace) {
  return PngChunk("IHDR",
                  BigEndian(width) + BigEndian(height) + Bytes({depth, colour, 0, 0, interlace}));
}

std::string Deflate(std::string_view bytes) {
  uLongf size = compressBound(bytes.size());
  std::string result(size, '\0');
  if (compress(reinterpret_cast<Bytef*>(result.data()), &size, Data(bytes), bytes.size()) != Z_OK) {
    throw std::runtime_error("zlib");
  }
  result.resize(size);
  return result;
}

std::string Filtered(int filter, size_t step, std::string_view row, std::string_view prior) {
  std::string result(1, static_cast<char>(filter));
  for (size_t i = 0; i < row.size(); ++i) {
    const int left = i < step ? 0 : static_cast<uint8_t>(row[i - step]);
    const int above = static_cast<uint8_t>(prior[i]);
    const int corner = i < step ? 0 : static_cast<uint8_t>(prior[i - step]);
    // Of the three neighbours the one nearest to the estimate; the first one if several are.
    const int estimate = left + above - corner;
    int paeth = left;
    if (std::abs(estimate - above) < std::abs(estimate - paeth)) paeth = above;
    if (std::abs(estimate - corner) < std::abs(estimate - paeth)) paeth = corner;
    const int predictions[] = {0, left, above, (left + above) / 2, paeth};
    result.push_back(static_cast<char>(static_cast<uint8_t>(row[i]) - predictions[filter]));
  }
  return result;
}

std::string PngFile(const std::vector<std::string>& chunks) {
  std::string result("\x89PNG\r\n\x1a\n", 8);
  for (const std::string& chunk : chunks) result += chunk;
  return result;
}

std::string PngOf(const std::string& header, std::string_view scanlines) {
  return PngFile({header, PngChunk("IDAT", Deflate(scanlines)), PngChunk("IEND", "")});
}

}  // namespace candela
