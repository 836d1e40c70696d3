// Of the libraries at hand, the PNG readers leave half of what we refuse to their callers (a
// palette index beyond the palette, a bad last checksum, surplus data), so the chunks have to be
// read here anyway. What is left is the decompression, for which libdeflate is three times as fast
// as zlib.
#include "image/png_read.h"

#include <fmt/format.h>
#include <libdeflate.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <memory>
#include <optional>

#include "image/adam7.h"
#include "image/big_endian.h"
#include "image/channels.h"
#include "image/png_chunks.h"
#include "image/png_filter.h"

namespace candela {
namespace {

Error Wrong(std::string text) {
  return {ErrorCode::kInput, std::move(text)};
}

// Deflate turns two bits into at most 258 bytes.
constexpr size_t kMostExpansion = 1032;

size_t RowBytes(const PngChunks& png, int64_t width) {
  return static_cast<size_t>((width * png.StoredChannels() * png.bit_depth + 7) / 8);
}

/// Bytes of all scanlines, each with its filter in front.
size_t ScanlineBytes(const PngChunks& png) {
  size_t total = 0;
  for (const PngPass& pass : PngPasses(png.interlaced)) {
    const int64_t width = pass.Width(png.width), height = pass.Height(png.height);
    if (width > 0) total += static_cast<size_t>(height) * (RowBytes(png, width) + 1);
  }
  return total;
}

/// Fills `out` from a stream that is known to hold more; the rest is never produced, so a file that
/// would expand to any size costs no more than its header promises.
bool InflateBeginning(std::string_view stream, std::vector<uint8_t>* out) {
  z_stream state{};
  if (inflateInit(&state) != Z_OK) return false;
  const std::unique_ptr<z_stream, int (*)(z_stream*)> end(&state, &inflateEnd);
  state.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(stream.data()));
  state.next_out = out->data();
  // zlib counts in 32 bits, so both sides are fed in pieces.
  constexpr size_t kPiece = size_t{1} << 30;
  size_t in_left = stream.size(), out_left = out->size();
  while (out_left > 0) {
    const auto in_piece = static_cast<uInt>(std::min(in_left, kPiece));
    const auto out_piece = static_cast<uInt>(std::min(out_left, kPiece));
    state.avail_in = in_piece;
    state.avail_out = out_piece;
    if (inflate(&state, Z_NO_FLUSH) != Z_OK) return out_left == out_piece - state.avail_out;
    in_left -= in_piece - state.avail_in;
    out_left -= out_piece - state.avail_out;
  }
  return true;
}

Result<std::vector<uint8_t>> Inflate(const PngChunks& png, std::vector<std::string>* warnings) {
  std::string joined;
  std::string_view stream = png.data.front();
  if (png.data.size() > 1) {
    for (const std::string_view piece : png.data) joined += piece;
    stream = joined;
  }
  const size_t expected = ScanlineBytes(png);
  if (expected / kMostExpansion > stream.size()) {
    return Wrong("there is too little data for a picture of this size");
  }

  std::vector<uint8_t> scanlines(expected);
  const std::unique_ptr<libdeflate_decompressor, void (*)(libdeflate_decompressor*)> decompressor(
      libdeflate_alloc_decompressor(), &libdeflate_free_decompressor);
  if (!decompressor) return Error{ErrorCode::kResources, "there is no memory for decompression"};
  size_t used = 0, produced = 0;
  libdeflate_result result =
      libdeflate_zlib_decompress_ex(decompressor.get(), stream.data(), stream.size(),
                                    scanlines.data(), expected, &used, &produced);
  const bool has_more = result == LIBDEFLATE_INSUFFICIENT_SPACE;
  if (has_more && InflateBeginning(stream, &scanlines)) {
    result = LIBDEFLATE_SUCCESS;
    produced = expected;
  }
  if (result != LIBDEFLATE_SUCCESS) return Wrong("the picture data is damaged or cut off");
  if (produced < expected) {
    return Wrong(fmt::format("there is too little data: {} of {} bytes", produced, expected));
  }
  if (warnings && (has_more || used < stream.size())) {
    warnings->push_back("there is more data than the picture needs");
  }
  return scanlines;
}

/// Turns the stored samples of one pixel into those of the result.
class PixelReader {
 public:
  explicit PixelReader(const PngChunks& png)
      : png_(png), stored_(png.StoredChannels()), has_key_(!png.transparency.empty()) {
    if (png.colour == PngColour::kPalette || !has_key_) return;
    for (size_t c = 0; c < static_cast<size_t>(stored_); ++c) {
      key_[c] = BigEndian16(png.transparency.data() + 2 * c);
    }
  }

  int Channels() const {
    return (png_.colour == PngColour::kPalette ? 3 : stored_) + (has_key_ ? 1 : 0);
  }

  /// True if a scanline holds the pixels just as the result does.
  bool IsCopy() const { return png_.bit_depth == 8 && !has_key_ && png_.palette.empty(); }

  /// The pixel number `x` of a scanline; false if it is a palette index without an entry.
  template <class T>
  bool Read(const uint8_t* row, int64_t x, T* out) const {
    if (png_.colour == PngColour::kPalette) return ReadIndexed(row, x, out);
    bool is_key = has_key_;
    for (int c = 0; c < stored_; ++c) {
      const int sample = Sample(row, x * stored_ + c);
      is_key = is_key && sample == key_[static_cast<size_t>(c)];
      out[c] =
          static_cast<T>(png_.bit_depth < 8 ? sample * 255 / ((1 << png_.bit_depth) - 1) : sample);
    }
    if (has_key_) out[stored_] = is_key ? 0 : static_cast<T>(~T{0});
    return true;
  }

 private:
  template <class T>
  bool ReadIndexed(const uint8_t* row, int64_t x, T* out) const {
    const auto index = static_cast<size_t>(Sample(row, x));
    if (index >= png_.palette.size() / 3) return false;
    for (size_t c = 0; c < 3; ++c) out[c] = static_cast<uint8_t>(png_.palette[3 * index + c]);
    if (has_key_) {
      // The table may be shorter than the palette: the other entries are opaque.
      out[3] =
          index < png_.transparency.size() ? static_cast<uint8_t>(png_.transparency[index]) : 255;
    }
    return true;
  }

  int Sample(const uint8_t* row, int64_t i) const {
    switch (png_.bit_depth) {
      case 16:
        return row[2 * i] << 8 | row[2 * i + 1];
      case 8:
        return row[i];
      default: {
        const int64_t bit = i * png_.bit_depth;  // The leftmost pixel has the highest bits.
        const int shift = 8 - png_.bit_depth - static_cast<int>(bit % 8);
        return row[bit / 8] >> shift & ((1 << png_.bit_depth) - 1);
      }
    }
  }

  const PngChunks& png_;
  int stored_;
  bool has_key_;
  std::array<int, 4> key_{};
};

/// Undoes the filters and puts the pixels of all passes into their places.
template <class T>
Result<Raster<T>> ReadPixels(const PngChunks& png, std::vector<uint8_t> scanlines) {
  const PixelReader reader(png);
  const int channels = reader.Channels();
  Raster<T> result(static_cast<int>(png.width), static_cast<int>(png.height), channels);
  const int filter_step = std::max(1, png.StoredChannels() * png.bit_depth / 8);
  uint8_t* row = scanlines.data();
  for (const PngPass& pass : PngPasses(png.interlaced)) {
    const int64_t width = pass.Width(png.width);
    if (width == 0) continue;
    const size_t row_bytes = RowBytes(png, width);
    const std::vector<uint8_t> zeros(row_bytes);
    const uint8_t* prior = zeros.data();
    for (int64_t y = pass.first_y; y < png.height; y += pass.step_y) {
      const uint8_t filter = *row++;
      if (filter > 4) return Wrong(fmt::format("{} is not a filter (0 to 4)", filter));
      UnfilterRow(static_cast<PngFilter>(filter), filter_step, row, prior, row_bytes);

      T* out = result.Row(static_cast<int>(y)).data() + pass.first_x * channels;
      if (reader.IsCopy() && pass.step_x == 1) {
        std::copy(row, row + row_bytes, out);
      } else {
        for (int64_t x = 0; x < width; ++x, out += pass.step_x * channels) {
          if (!reader.Read(row, x, out)) {
            return Wrong(
                fmt::format("a pixel in row {} has a colour number beyond the {} of the palette", y,
                            png.palette.size() / 3));
          }
        }
      }
      prior = row;
      row += row_bytes;
    }
  }
  return result;
}

template <class T>
Result<PngImage> Decode(const PngChunks& png, std::vector<std::string>* warnings) {
  Result<std::vector<uint8_t>> scanlines = Inflate(png, warnings);
  if (!scanlines) return scanlines.error();
  Result<Raster<T>> pixels = ReadPixels<T>(png, *std::move(scanlines));
  if (!pixels) return pixels.error();
  return PngImage{*std::move(pixels)};
}

}  // namespace

int PngImage::Width() const {
  return std::visit([](const auto& image) { return image.Width(); }, pixels);
}
int PngImage::Height() const {
  return std::visit([](const auto& image) { return image.Height(); }, pixels);
}
int PngImage::Channels() const {
  return std::visit([](const auto& image) { return image.Channels(); }, pixels);
}
Image PngImage::ToFloat() const {
  return std::visit([](const auto& image) { return candela::ToFloat(image); }, pixels);
}

Result<PngImage> DecodePng(std::string_view bytes, std::vector<std::string>* warnings,
                           int64_t most_bytes) {
  Result<PngChunks> png = ReadPngChunks(bytes, warnings);
  if (!png) return png.error();
  const bool is_words = png->bit_depth == 16;
  const int bytes_per_pixel = PixelReader(*png).Channels() * (is_words ? 2 : 1);
  const Result<void> size = CheckImageSize(png->width, png->height, bytes_per_pixel, most_bytes);
  if (!size) return size.error();
  return is_words ? Decode<uint16_t>(*png, warnings) : Decode<uint8_t>(*png, warnings);
}

}  // namespace candela
