#include "image/pfm.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstring>

#include "base/number.h"
#include "base/text.h"
#include "image/channels.h"

namespace candela {
namespace {

constexpr std::string_view kBlanks = " \t\r\n";

Error Wrong(std::string text) {
  return {ErrorCode::kInput, std::move(text)};
}

/// The next word, without the blanks before it. A header has four words; the pixels begin after one
/// blank.
std::string_view TakeWord(std::string_view* rest) {
  rest->remove_prefix(std::min(rest->find_first_not_of(kBlanks), rest->size()));
  const std::string_view word = rest->substr(0, rest->find_first_of(kBlanks));
  rest->remove_prefix(word.size());
  return word;
}

/// Turns the bits of a float from the machine's order into another, or back.
uint32_t Reorder(uint32_t bits, ByteOrder order) {
  if ((order == ByteOrder::kBig) == (std::endian::native == std::endian::big)) return bits;
  return bits >> 24 | (bits >> 8 & 0xff00) | (bits << 8 & 0xff0000) | bits << 24;
}

}  // namespace

Result<Image> DecodePfm(std::string_view bytes, std::vector<std::string>* warnings,
                        int64_t most_bytes) {
  std::string_view rest = bytes;
  const std::string_view kind = TakeWord(&rest);
  if (bytes.empty() || !bytes.starts_with(kind) || (kind != "PF" && kind != "Pf")) {
    return Wrong("this is not a portable float map");
  }
  const std::string_view width = TakeWord(&rest), height = TakeWord(&rest), scale = TakeWord(&rest);
  const std::optional<int64_t> w = ParseInteger(width), h = ParseInteger(height);
  const std::optional<float> s = ParseFloat(scale);
  if (!w || !h || !s || *s == 0 || rest.empty()) {
    return Wrong(fmt::format("expected width, height and a scale other than 0, found {}, {}, {}",
                             Quote(width), Quote(height), Quote(scale)));
  }
  rest.remove_prefix(1);
  const int channels = kind == "PF" ? 3 : 1;
  const Result<void> fits = CheckImageSize(*w, *h, channels * int64_t{sizeof(float)}, most_bytes);
  if (!fits) return fits.error();
  const size_t expected = static_cast<size_t>(*w * *h * channels) * sizeof(float);
  if (rest.size() < expected) {
    return Wrong(fmt::format("there is too little data: {} of {} bytes", rest.size(), expected));
  }
  if (warnings && rest.size() > expected) {
    warnings->push_back("there is more data than the picture needs");
  }

  Image image(static_cast<int>(*w), static_cast<int>(*h), channels);
  const ByteOrder order = *s > 0 ? ByteOrder::kBig : ByteOrder::kLittle;
  const char* from = rest.data();
  for (int y = image.Height() - 1; y >= 0; --y) {
    for (float& value : image.Row(y)) {
      uint32_t bits;
      std::memcpy(&bits, from, sizeof(bits));
      value = std::bit_cast<float>(Reorder(bits, order));
      from += sizeof(bits);
    }
  }
  return image;
}

Result<std::string> EncodePfm(const Image& image, ByteOrder order) {
  CHECK(image.Channels() <= 4);
  if (image.IsEmpty()) return Error{ErrorCode::kUsage, "a PFM file holds at least one pixel"};
  if (image.Channels() == 2) return EncodePfm(WithChannels(image, 1), order);
  if (image.Channels() == 4) return EncodePfm(WithChannels(image, 3), order);

  std::string out =
      fmt::format("{}\n{} {}\n{}\n", image.Channels() == 3 ? "PF" : "Pf", image.Width(),
                  image.Height(), order == ByteOrder::kBig ? "1.0" : "-1.0");
  size_t to = out.size();
  out.resize(to + image.Samples().size_bytes());
  for (int y = image.Height() - 1; y >= 0; --y) {
    for (const float value : image.Row(y)) {
      const uint32_t bits = Reorder(std::bit_cast<uint32_t>(value), order);
      std::memcpy(out.data() + to, &bits, sizeof(bits));
      to += sizeof(bits);
    }
  }
  return out;
}

}  // namespace candela
