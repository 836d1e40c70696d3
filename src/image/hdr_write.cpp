#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "image/channels.h"
#include "image/hdr.h"

namespace candela {
namespace {

using Rgbe = std::array<uint8_t, 4>;

/// Three mantissas of 8 bits under the exponent of the largest: value = mantissa * 2^(exponent -
/// 136).
Rgbe ToRgbe(std::span<const float> colour) {
  constexpr float kLargest = 0x1.fep+126f;  // 255 * 2^(255 - 136)
  std::array<float, 3> c;
  for (size_t i = 0; i < 3; ++i) c[i] = colour[i] > 0 ? std::min(colour[i], kLargest) : 0;
  const float most = std::max({c[0], c[1], c[2]});
  int exponent = 0;
  std::frexp(most, &exponent);  // most < 2^exponent
  // Rounding may carry the largest mantissa to 256, which the next exponent holds as 128.
  if (std::floor(std::ldexp(most, 8 - exponent) + 0.5f) == 256.0f) ++exponent;
  if (most == 0 || exponent + 128 < 1) return {};
  Rgbe pixel;
  for (size_t i = 0; i < 3; ++i) {
    pixel[i] = static_cast<uint8_t>(std::floor(std::ldexp(c[i], 8 - exponent) + 0.5f));
  }
  pixel[3] = static_cast<uint8_t>(exponent + 128);
  return pixel;
}

/// Length of the run of equal values at x; at most 127, which is what one code holds.
size_t RunLength(const std::vector<Rgbe>& row, size_t component, size_t x) {
  size_t end = x + 1;
  while (end < row.size() && end - x < 127 && row[end][component] == row[x][component]) ++end;
  return end - x;
}

/// Runs of four and more are worth a code of their own.
void AppendComponent(const std::vector<Rgbe>& row, size_t component, std::string* out) {
  constexpr size_t kWorthwhile = 4;
  for (size_t x = 0; x < row.size();) {
    const size_t run = RunLength(row, component, x);
    if (run >= kWorthwhile) {
      out->push_back(static_cast<char>(128 + run));
      out->push_back(static_cast<char>(row[x][component]));
      x += run;
      continue;
    }
    size_t end = x + run;
    while (end < row.size()) {
      const size_t next = RunLength(row, component, end);
      if (next >= kWorthwhile || end + next - x > 128) break;
      end += next;
    }
    out->push_back(static_cast<char>(end - x));
    for (; x < end; ++x) out->push_back(static_cast<char>(row[x][component]));
  }
}

}  // namespace

Result<std::string> EncodeHdr(const Image& image) {
  CHECK(image.Channels() <= 4);
  if (image.IsEmpty()) return Error{ErrorCode::kUsage, "an HDR file holds at least one pixel"};
  if (image.Channels() != 3) return EncodeHdr(WithChannels(image, 3));

  std::string out = fmt::format("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y {} +X {}\n",
                                image.Height(), image.Width());
  const bool is_coded = image.Width() >= 8 && image.Width() <= 0x7fff;
  std::vector<Rgbe> row(static_cast<size_t>(image.Width()));
  for (int y = 0; y < image.Height(); ++y) {
    for (int x = 0; x < image.Width(); ++x) row[static_cast<size_t>(x)] = ToRgbe(image.Pixel(x, y));
    if (is_coded) {
      out.append({2, 2, static_cast<char>(image.Width() >> 8), static_cast<char>(image.Width())});
      for (size_t component = 0; component < 4; ++component) AppendComponent(row, component, &out);
    } else {
      for (const Rgbe& pixel : row) out.append(pixel.begin(), pixel.end());
    }
  }
  return out;
}

}  // namespace candela
