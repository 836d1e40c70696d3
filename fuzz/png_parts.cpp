#include "fuzz/png_parts.h"

#include <zlib.h>

#include <algorithm>

namespace candela::fuzz {
namespace {

constexpr std::string_view kSignature("\x89PNG\r\n\x1a\n", 8);

const Bytef* AsBytes(std::string_view text) {
  return reinterpret_cast<const Bytef*>(text.data());
}

uint32_t ReadNumber(std::string_view bytes) {
  uint32_t number = 0;
  for (const char c : bytes.substr(0, 4)) number = number << 8 | static_cast<unsigned char>(c);
  return number;
}

void AppendNumber(uint32_t number, std::string* out) {
  for (const int shift : {24, 16, 8, 0}) *out += static_cast<char>(number >> shift & 0xFF);
}

}  // namespace

std::vector<PngPart> SplitPng(std::string_view bytes) {
  std::vector<PngPart> parts;
  bytes.remove_prefix(std::min(bytes.size(), kSignature.size()));
  while (bytes.size() >= 8) {
    const size_t length = std::min<size_t>(ReadNumber(bytes), bytes.size() - 8);
    parts.push_back({std::string(bytes.substr(4, 4)), std::string(bytes.substr(8, length))});
    bytes.remove_prefix(std::min(bytes.size(), length + 12));
  }
  return parts;
}

std::string JoinPng(const std::vector<PngPart>& parts) {
  std::string bytes(kSignature);
  for (const PngPart& part : parts) {
    const std::string checked = part.type + part.content;
    AppendNumber(static_cast<uint32_t>(part.content.size()), &bytes);
    bytes += checked;
    AppendNumber(
        static_cast<uint32_t>(crc32(0, AsBytes(checked), static_cast<uInt>(checked.size()))),
        &bytes);
  }
  return bytes;
}

std::string ExpandData(const std::vector<PngPart>& parts, size_t most) {
  std::string stream, data(most, '\0');
  for (const PngPart& part : parts) {
    if (part.type == "IDAT") stream += part.content;
  }
  z_stream state{};
  if (inflateInit(&state) != Z_OK) return {};
  state.next_in = const_cast<Bytef*>(AsBytes(stream));
  state.avail_in = static_cast<uInt>(stream.size());
  state.next_out = reinterpret_cast<Bytef*>(data.data());
  state.avail_out = static_cast<uInt>(data.size());
  (void)inflate(&state, Z_FINISH);  // Damaged data ends early; what came before it will do.
  data.resize(data.size() - state.avail_out);
  inflateEnd(&state);
  return data;
}

std::string Compress(std::string_view data) {
  uLongf size = compressBound(static_cast<uLong>(data.size()));
  std::string stream(size, '\0');
  compress2(reinterpret_cast<Bytef*>(stream.data()), &size, AsBytes(data),
            static_cast<uLong>(data.size()), 1);
  stream.resize(size);
  return stream;
}

}  // namespace candela::fuzz
