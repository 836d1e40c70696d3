#include "image/png_unpack.h"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <span>

namespace candela {
namespace {

constexpr size_t kMostBlock = 65535;  // A stored block counts its bytes with 16 bits.

/// Bytes of all scanlines, each with its filter in front.
size_t ScanlineBytes(const PngChunks& png) {
  struct Pass {
    size_t first_x, first_y, step_x, step_y;
  };
  // ISO/IEC 15948, clause 8.
  static constexpr Pass kAdam7[] = {{0, 0, 8, 8}, {4, 0, 8, 8}, {0, 4, 4, 8}, {2, 0, 4, 4},
                                    {0, 2, 2, 4}, {1, 0, 2, 2}, {0, 1, 1, 2}};
  static constexpr Pass kPlain[] = {{0, 0, 1, 1}};
  std::span<const Pass> passes = kPlain;
  if (png.header.interlace_method != 0) passes = kAdam7;
  size_t total = 0;
  for (const Pass& pass : passes) {
    const size_t width = (png.header.width + pass.step_x - 1 - pass.first_x) / pass.step_x;
    const size_t height = (png.header.height + pass.step_y - 1 - pass.first_y) / pass.step_y;
    const size_t bits = width * static_cast<size_t>(png.StoredChannels()) * png.header.bit_depth;
    if (width > 0) total += height * ((bits + 7) / 8 + 1);
  }
  return total;
}

/// The compressed stream that the data chunks hold together.
class Inflater {
 public:
  explicit Inflater(std::span<const std::string_view> pieces) : pieces_(pieces) {
    is_sound_ = inflateInit(&state_) == Z_OK;
  }
  ~Inflater() { inflateEnd(&state_); }
  Inflater(const Inflater&) = delete;
  Inflater& operator=(const Inflater&) = delete;

  /// Unpacks up to `size` bytes and returns how many; fewer if the data ends or is not sound.
  size_t Take(char* to, size_t size) {
    state_.next_out = reinterpret_cast<Bytef*>(to);
    state_.avail_out = static_cast<uInt>(size);
    while (state_.avail_out > 0 && is_sound_ && !has_ended_) {
      if (state_.avail_in == 0 && !pieces_.empty()) {
        state_.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(pieces_[0].data()));
        state_.avail_in = static_cast<uInt>(pieces_[0].size());
        pieces_ = pieces_.subspan(1);
        continue;
      }
      const int code = inflate(&state_, Z_NO_FLUSH);
      has_ended_ = code == Z_STREAM_END;  // Only with the right checksum.
      is_sound_ = code == Z_OK || has_ended_;
    }
    return size - state_.avail_out;
  }

  bool IsSound() const { return is_sound_; }
  /// Whether pieces are left that were not looked at, empty ones aside.
  bool HasInput() const {
    return state_.avail_in > 0 ||
           std::any_of(pieces_.begin(), pieces_.end(), [](auto piece) { return !piece.empty(); });
  }

 private:
  std::span<const std::string_view> pieces_;
  z_stream state_{};
  bool is_sound_, has_ended_ = false;
};

void AppendBigEndian32(size_t value, std::string* out) {
  for (int shift = 24; shift >= 0; shift -= 8) out->push_back(static_cast<char>(value >> shift));
}

void AppendChunk(std::string_view type, std::string_view content, std::string* out) {
  AppendBigEndian32(content.size(), out);
  out->append(type).append(content).append(4, '\0');
}

}  // namespace

Result<UnpackedPng> UnpackPng(const PngChunks& png) {
  const size_t expected = ScanlineBytes(png);
  size_t packed = 0;
  for (const std::string_view piece : png.data) packed += piece.size();
  constexpr size_t kMostExpansion = 1032;  // Deflate turns two bits into at most 258 bytes.
  if (expected / kMostExpansion > packed) {
    return Error{ErrorCode::kInput, "there is too little data for a picture of this size"};
  }

  UnpackedPng result;
  result.file = kPngSignature;
  std::string header;
  AppendBigEndian32(png.header.width, &header);
  AppendBigEndian32(png.header.height, &header);
  const uint8_t colour = png.IsIndexed() ? uint8_t{0} : png.header.color_type;
  for (const uint8_t byte : {png.header.bit_depth, colour, png.header.compression_method,
                             png.header.filter_method, png.header.interlace_method}) {
    header.push_back(static_cast<char>(byte));
  }
  AppendChunk("IHDR", header, &result.file);
  AppendChunk("IDAT", "\x78\x01", &result.file);  // The head of a zlib stream (RFC 1950).

  result.file.reserve(result.file.size() + expected + (expected / kMostBlock + 1) * 17);

  Inflater data(png.data);
  std::string block;
  for (size_t done = 0; done < expected;) {
    // A stored block, not the last one: its size, and the same inverted (RFC 1951, 3.2.4).
    const size_t size = std::min(expected - done, kMostBlock);
    block.assign(1, '\0');
    for (const size_t number : {size, ~size}) {
      block.push_back(static_cast<char>(number));
      block.push_back(static_cast<char>(number >> 8));
    }
    block.resize(5 + size);
    const size_t taken = data.Take(block.data() + 5, size);
    done += taken;
    if (!data.IsSound()) break;
    if (taken < size) {
      return Error{ErrorCode::kInput,
                   fmt::format("there is too little data: {} of {} bytes", done, expected)};
    }
    AppendChunk("IDAT", block, &result.file);
  }
  char spare;
  result.has_surplus = data.Take(&spare, 1) > 0 || data.HasInput();
  if (!data.IsSound()) return Error{ErrorCode::kInput, "the picture data is damaged or cut off"};
  return result;
}

}  // namespace candela
