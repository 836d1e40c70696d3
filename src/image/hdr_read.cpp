// Own code, since stb_image takes missing rows, unknown formats and surplus runs in silence.
// The format: Greg Ward, "Real Pixels", Graphics Gems II, 1991, and the Radiance reader color.c.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/number.h"
#include "base/text.h"
#include "image/hdr.h"

namespace candela {
namespace {

using Rgbe = std::array<uint8_t, 4>;

Error Wrong(std::string text) {
  return {ErrorCode::kInput, std::move(text)};
}

/// The text up to the next line end, which is taken too; nothing when there is none.
std::optional<std::string_view> TakeLine(std::string_view* rest) {
  const size_t end = rest->find('\n');
  if (end == std::string_view::npos) return std::nullopt;
  const std::string_view line = rest->substr(0, end);
  rest->remove_prefix(end + 1);
  return line;
}

std::string_view TakeWord(std::string_view* line) {
  line->remove_prefix(std::min(line->find_first_not_of(" \r"), line->size()));
  const std::string_view word = line->substr(0, line->find_first_of(" \r"));
  line->remove_prefix(word.size());
  return word;
}

struct Layout {
  int64_t width = 0, height = 0;
  bool bottom_first = false;  // +Y
  bool right_first = false;   // -X
};

/// Reads "-Y 480 +X 640" and its mirrored forms.
Result<Layout> ReadResolution(std::string_view line) {
  std::string_view rest = line;
  const std::string_view y = TakeWord(&rest), height = TakeWord(&rest);
  const std::string_view x = TakeWord(&rest), width = TakeWord(&rest);
  if ((y == "-X" || y == "+X") && (x == "-Y" || x == "+Y")) {
    return Wrong("pictures stored by columns are not supported");
  }
  const std::optional<int64_t> h = ParseInteger(height), w = ParseInteger(width);
  if ((y != "-Y" && y != "+Y") || (x != "-X" && x != "+X") || !h || !w ||
      !TakeWord(&rest).empty()) {
    return Wrong(fmt::format("expected a size such as '-Y 480 +X 640', found {}", Quote(line)));
  }
  return Layout{*w, *h, y == "+Y", x == "-X"};
}

Result<Layout> ReadHeader(std::string_view* rest) {
  if (!rest->starts_with("#?")) return Wrong("this is not a Radiance picture");
  for (std::optional<std::string_view> line = TakeLine(rest); line; line = TakeLine(rest)) {
    if (line->empty() || *line == "\r") {
      line = TakeLine(rest);
      if (!line) break;
      return ReadResolution(*line);
    }
    if (line->starts_with("FORMAT=")) {
      std::string_view format = line->substr(7);
      const std::string_view name = TakeWord(&format);
      if (name != "32-bit_rle_rgbe") {
        return Wrong(fmt::format("the format {} is not supported", Quote(name)));
      }
    }
  }
  return Wrong("the file ends inside its header");
}

/// The coding since 1991: each of the four components of a row on its own, in runs (a count above
/// 128, then the value) and literal stretches.
bool ReadComponents(std::string_view* rest, std::vector<Rgbe>* row) {
  for (size_t component = 0; component < 4; ++component) {
    for (size_t x = 0; x < row->size();) {
      if (rest->size() < 2) return false;
      const auto code = static_cast<uint8_t>(rest->front());
      const bool is_run = code > 128;
      const size_t count = is_run ? code - 128u : code;
      if (count == 0 || count > row->size() - x || (!is_run && count >= rest->size())) return false;
      for (size_t i = 0; i < count; ++i) {
        (*row)[x + i][component] = static_cast<uint8_t>((*rest)[is_run ? 1 : 1 + i]);
      }
      x += count;
      rest->remove_prefix(is_run ? 2 : 1 + count);
    }
  }
  return true;
}

/// The coding before: whole pixels, where (1, 1, 1, n) repeats the last one n times; directly
/// following repeats are the higher digits of the count.
bool ReadPixels(std::string_view* rest, std::vector<Rgbe>* row) {
  int shift = 0;
  for (size_t x = 0; x < row->size();) {
    if (rest->size() < 4) return false;
    Rgbe pixel;
    for (size_t c = 0; c < 4; ++c) pixel[c] = static_cast<uint8_t>((*rest)[c]);
    rest->remove_prefix(4);
    if (pixel[0] == 1 && pixel[1] == 1 && pixel[2] == 1) {
      if (x == 0 || shift > 16) return false;
      const size_t count = size_t{pixel[3]} << shift;
      if (count > row->size() - x) return false;
      std::fill_n(row->begin() + static_cast<ptrdiff_t>(x), count, (*row)[x - 1]);
      x += count;
      shift += 8;
    } else {
      (*row)[x++] = pixel;
      shift = 0;
    }
  }
  return true;
}

/// The fewest bytes that a row can have. Those are in the coding before 1991: a pixel and its
/// repeats, of which the third one has the highest digit.
int64_t LeastBytesOfRow(int64_t width) {
  constexpr int64_t kReach[] = {1, 1 << 8, 1 << 16, 1 << 24};  // Of a pixel with 0 to 3 repeats.
  const int64_t left = width % kReach[3];
  int64_t words = width / kReach[3] * 4;
  if (left > 0) words += std::lower_bound(std::begin(kReach), std::end(kReach), left) - kReach + 1;
  return 4 * words;
}

bool ReadRow(std::string_view* rest, std::vector<Rgbe>* row) {
  const auto byte = [&](size_t i) { return static_cast<uint8_t>((*rest)[i]); };
  // A row of components begins with 2 2 and the width, which no pixel does.
  if (row->size() >= 8 && row->size() <= 0x7fff && rest->size() >= 4 && byte(0) == 2 &&
      byte(1) == 2 && byte(2) < 128) {
    if (row->size() != static_cast<size_t>(byte(2) << 8 | byte(3))) return false;
    rest->remove_prefix(4);
    return ReadComponents(rest, row);
  }
  return ReadPixels(rest, row);
}

}  // namespace

Result<Image> DecodeHdr(std::string_view bytes, std::vector<std::string>* warnings,
                        int64_t most_bytes) {
  std::string_view rest = bytes;
  const Result<Layout> layout = ReadHeader(&rest);
  if (!layout) return layout.error();
  const Result<void> fits =
      CheckImageSize(layout->width, layout->height, 3 * int64_t{sizeof(float)}, most_bytes);
  if (!fits) return fits.error();
  const int64_t least_bytes = LeastBytesOfRow(layout->width);
  if (layout->height > static_cast<int64_t>(rest.size()) / least_bytes) {
    return Wrong("there is too little data for a picture of this size");
  }

  std::array<float, 256> scale{};  // An exponent of 0 means black.
  for (int e = 1; e < 256; ++e) scale[static_cast<size_t>(e)] = std::ldexp(1.0f, e - 136);

  Image image;  // Takes its memory once a row has shown that there is a picture.
  const auto width = static_cast<int>(layout->width), height = static_cast<int>(layout->height);
  std::vector<Rgbe> row(static_cast<size_t>(width));
  for (int i = 0; i < height; ++i) {
    if (!ReadRow(&rest, &row)) return Wrong(fmt::format("row {} is damaged or cut off", i + 1));
    if (image.IsEmpty()) image = Image(width, height, 3);
    const int y = layout->bottom_first ? height - 1 - i : i;
    if (layout->right_first) std::reverse(row.begin(), row.end());
    float* out = image.Row(y).data();
    for (const Rgbe& pixel : row) {
      for (size_t c = 0; c < 3; ++c) *out++ = static_cast<float>(pixel[c]) * scale[pixel[3]];
    }
  }
  if (warnings && !rest.empty()) warnings->push_back("there is more data than the picture needs");
  return image;
}

}  // namespace candela
