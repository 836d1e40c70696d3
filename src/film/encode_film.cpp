#include "film/encode_film.h"

#include <algorithm>
#include <span>
#include <utility>

#include "image/quantise.h"

namespace candela {

Image ToImage(const Film& film) {
  const PixelWindow& window = film.Window();
  Image picture(window.Width(), window.Height(), 3);
  for (int y = 0; y < window.Height(); ++y) {
    std::ranges::copy(film.Row(window.y0 + y), picture.Row(y).begin());
  }
  return picture;
}

namespace {

/// Layers of a film in one file with its colours, which are those of `colours`.
Result<std::string> EncodeLayers(const Film& film, const float* colours,
                                 const EncodeOptions& options) {
  const PixelWindow& window = film.Window();
  std::vector<ExrChannel> channels;
  for (const char* name : {"R", "G", "B"}) channels.push_back({name, false, colours++, 3});
  for (size_t i = 0; i < kLayerCount; ++i) {
    const auto layer = static_cast<Layer>(i);
    if (!film.RecordedLayers().Has(layer)) continue;
    const LayerEntry& entry = EntryOf(layer);
    const uint32_t* words = film.LayerWords(layer).data();
    const std::vector<std::string> names = film.NamesOf(layer);
    const size_t stride = names.size() * entry.channels.size();
    for (const std::string& name : names) {
      for (const char channel : entry.channels) {
        channels.push_back(
            {name + "." + channel, entry.is_whole, words++, static_cast<int>(stride)});
      }
    }
  }
  return EncodeExr(window.Width(), window.Height(), channels, options.attributes);
}

}  // namespace

FilmEncoder::FilmEncoder(const Film& film, ImageFormat format, const EncodeOptions& options,
                         Finishing finishing)
    : film_(film), format_(format), options_(options), finishing_(std::move(finishing)) {
  if (finishing_ || format != ImageFormat::kPng || options.png_bits != 8) return;
  const PixelWindow& window = film.Window();
  png_.emplace(window.Width(), window.Height(), 3, 8, PngEffort::kFast);
}

void FilmEncoder::Advance(int y_end) {
  if (!png_) return;
  for (; next_row_ < y_end; ++next_row_) {
    const std::span<const float> row = film_.Row(film_.Window().y0 + next_row_);
    bytes_.resize(row.size());
    if (options_.tone.curve) {
      for (size_t i = 0; i < row.size(); i += 3) {
        const Rgb c = options_.tone.Encode({row[i], row[i + 1], row[i + 2]});
        bytes_[i] = RoundToByte(c.x);
        bytes_[i + 1] = RoundToByte(c.y);
        bytes_[i + 2] = RoundToByte(c.z);
      }
      png_->Add(std::as_bytes(std::span(bytes_)));
      continue;
    }
    // In a lambda, which is expanded in place where a pointer to the function would be called.
    std::ranges::transform(row, bytes_.begin(), [](float value) { return QuantiseToByte(value); });
    png_->Add(std::as_bytes(std::span(bytes_)));
  }
}

Result<std::string> FilmEncoder::Finish() {
  const bool has_layers = !film_.RecordedLayers().IsEmpty();
  if (has_layers) CHECK(format_ == ImageFormat::kExr);
  if (finishing_) {
    Image picture = ToImage(film_);
    finishing_(&picture);
    return has_layers ? EncodeLayers(film_, picture.Samples().data(), options_)
                      : EncodeImage(picture, format_, options_);
  }
  if (has_layers) return EncodeLayers(film_, film_.Row(film_.Window().y0).data(), options_);
  if (!png_) return EncodeImage(ToImage(film_), format_, options_);
  Advance(film_.Window().Height());
  return png_->Finish();
}

}  // namespace candela
