#include "image/png_read.h"

#include <fmt/format.h>
#include <spng.h>

#include <algorithm>
#include <array>
#include <memory>

#include "image/channels.h"
#include "image/png_chunks.h"
#include "image/png_unpack.h"

namespace candela {
namespace {

Error Wrong(std::string text) {
  return {ErrorCode::kInput, std::move(text)};
}

/// The samples as stored; those of fewer than 8 bits are spread over 0..255, indices too.
template <class T>
Result<Raster<T>> DecodeSamples(const PngChunks& png, std::vector<std::string>* warnings) {
  const Result<UnpackedPng> unpacked = UnpackPng(png);
  if (!unpacked) return unpacked.error();
  Raster<T> samples(static_cast<int>(png.header.width), static_cast<int>(png.header.height),
                    png.StoredChannels());
  const std::unique_ptr<spng_ctx, void (*)(spng_ctx*)> context(spng_ctx_new(0), &spng_ctx_free);
  spng_set_crc_action(context.get(), SPNG_CRC_USE, SPNG_CRC_USE);
  spng_set_png_buffer(context.get(), unpacked->file.data(), unpacked->file.size());
  const int format = png.header.bit_depth < 8 ? SPNG_FMT_G8 : SPNG_FMT_PNG;
  const std::span<T> out = samples.Samples();
  const int code = spng_decode_image(context.get(), out.data(), out.size_bytes(), format, 0);
  if (code != SPNG_OK) return Wrong(fmt::format("the pixels are wrong: {}", spng_strerror(code)));
  if (unpacked->has_surplus && warnings) {
    warnings->push_back("there is more data than the picture needs");
  }
  return samples;
}

/// The factor that spreads samples of fewer than 8 bits over 0..255.
int Spread(const PngChunks& png) {
  return png.header.bit_depth < 8 ? 255 / ((1 << png.header.bit_depth) - 1) : 1;
}

int ResultChannels(const PngChunks& png) {
  return (png.IsIndexed() ? 3 : png.StoredChannels()) + (png.transparency.empty() ? 0 : 1);
}

Result<ByteImage> LookUpColours(const PngChunks& png, const ByteImage& indices) {
  const size_t count = png.palette.size() / 3;
  // The table of alphas may be shorter than the palette: the other entries are opaque.
  std::array<std::array<uint8_t, 4>, 256> colours;
  for (size_t i = 0; i < count; ++i) {
    for (size_t c = 0; c < 3; ++c) colours[i][c] = static_cast<uint8_t>(png.palette[3 * i + c]);
    colours[i][3] =
        i < png.transparency.size() ? static_cast<uint8_t>(png.transparency[i]) : uint8_t{255};
  }
  const int channels = ResultChannels(png), spread = Spread(png);
  ByteImage image(indices.Width(), indices.Height(), channels);
  for (int y = 0; y < image.Height(); ++y) {
    uint8_t* out = image.Row(y).data();
    for (const uint8_t sample : indices.Row(y)) {
      const auto index = static_cast<size_t>(sample / spread);
      if (index >= count) {
        return Wrong(fmt::format(
            "a pixel in row {} has a colour number beyond the {} of the palette", y, count));
      }
      out = std::copy_n(colours[index].data(), channels, out);
    }
  }
  return image;
}

/// Adds an alpha of zero where a pixel has the transparent colour.
template <class T>
Raster<T> AddAlpha(const PngChunks& png, const Raster<T>& colours) {
  const int channels = colours.Channels();
  std::array<int, 3> key{};  // As an int, it may be a value that no sample has.
  for (size_t c = 0; c < static_cast<size_t>(channels); ++c) {
    const auto high = static_cast<uint8_t>(png.transparency[2 * c]);
    const auto low = static_cast<uint8_t>(png.transparency[2 * c + 1]);
    key[c] = (high << 8 | low) * Spread(png);
  }
  Raster<T> image(colours.Width(), colours.Height(), channels + 1);
  T* out = image.Samples().data();
  const std::span<const T> all = colours.Samples();
  for (const T* pixel = all.data(); pixel != all.data() + all.size(); pixel += channels) {
    const bool is_key = std::equal(pixel, pixel + channels, key.begin());
    out = std::copy_n(pixel, channels, out);
    *out++ = is_key ? T{0} : static_cast<T>(~T{0});
  }
  return image;
}

template <class T>
Result<PngImage> Decode(const PngChunks& png, std::vector<std::string>* warnings) {
  Result<Raster<T>> samples = DecodeSamples<T>(png, warnings);
  if (!samples) return samples.error();
  if constexpr (sizeof(T) == 1) {
    if (png.IsIndexed()) {
      Result<ByteImage> image = LookUpColours(png, *samples);
      if (!image) return image.error();
      return PngImage{*std::move(image)};
    }
  }
  if (!png.transparency.empty()) return PngImage{AddAlpha(png, *samples)};
  return PngImage{*std::move(samples)};
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
  const Result<PngChunks> png = ReadPngChunks(bytes, warnings);
  if (!png) return png.error();
  const bool is_words = png->header.bit_depth == 16;
  const Result<void> size = CheckImageSize(png->header.width, png->header.height,
                                           ResultChannels(*png) * (is_words ? 2 : 1), most_bytes);
  if (!size) return size.error();
  return is_words ? Decode<uint16_t>(*png, warnings) : Decode<uint8_t>(*png, warnings);
}

}  // namespace candela
