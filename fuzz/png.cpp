// PNG files. A checksum guards every chunk and the pixels are compressed, so that changed bytes
// alone would never get past the first check: the mutator changes what is inside and makes the rest
// fit.
#include <algorithm>
#include <cstring>
#include <random>

#include "base/check.h"
#include "fuzz/png_parts.h"
#include "image/png_read.h"
#include "image/png_write.h"

extern "C" size_t LLVMFuzzerMutate(unsigned char* data, size_t size, size_t most);

namespace {

using candela::fuzz::PngPart;

constexpr size_t kMostData = 1 << 16;

/// What libFuzzer does to a text of its own.
std::string Mutated(std::string text, size_t most_growth) {
  const size_t size = text.size();
  text.resize(size + most_growth);
  text.resize(LLVMFuzzerMutate(reinterpret_cast<unsigned char*>(text.data()), size, text.size()));
  return text;
}

/// Puts new pixel data in the place of all IDAT chunks, cut in two at times.
void ReplaceData(const std::string& stream, bool in_two, std::vector<PngPart>* parts) {
  const auto is_data = [](const PngPart& part) { return part.type == "IDAT"; };
  const auto first = std::find_if(parts->begin(), parts->end(), is_data);
  const auto place = first - parts->begin();
  parts->erase(std::remove_if(parts->begin(), parts->end(), is_data), parts->end());
  const size_t cut = in_two ? stream.size() / 2 : stream.size();
  parts->insert(parts->begin() + place, {"IDAT", stream.substr(0, cut)});
  if (in_two) parts->insert(parts->begin() + place + 1, {"IDAT", stream.substr(cut)});
}

void MutateParts(std::minstd_rand& random, std::vector<PngPart>* parts) {
  const auto pick = [&] { return parts->begin() + static_cast<long>(random() % parts->size()); };
  switch (random() % 6) {
    case 0:
    case 1: {
      PngPart& part = *pick();
      part.content = Mutated(std::move(part.content), 64);
      break;
    }
    case 2:
    case 3:
      ReplaceData(candela::fuzz::Compress(Mutated(ExpandData(*parts, kMostData), 64)),
                  random() % 4 == 0, parts);
      break;
    case 4: {
      const PngPart copy = *pick();
      parts->insert(pick(), copy);
      break;
    }
    default:
      if (random() % 2 == 0) {
        parts->erase(pick());
      } else {
        std::iter_swap(pick(), pick());
      }
  }
}

}  // namespace

extern "C" size_t LLVMFuzzerCustomMutator(unsigned char* data, size_t size, size_t most,
                                          unsigned seed) {
  std::minstd_rand random(seed);
  auto parts = candela::fuzz::SplitPng({reinterpret_cast<const char*>(data), size});
  // Now and then the file as such: cut, surplus, wrong checksums and lengths.
  if (parts.empty() || random() % 8 == 0) return LLVMFuzzerMutate(data, size, most);
  MutateParts(random, &parts);
  const std::string file = JoinPng(parts);
  const size_t length = std::min(file.size(), most);
  std::memcpy(data, file.data(), length);
  return length;
}

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, size_t size) {
  using namespace candela;
  constexpr int64_t kMostBytes = 1 << 22;
  std::vector<std::string> warnings;
  const auto decoded =
      DecodePng({reinterpret_cast<const char*>(data), size}, &warnings, kMostBytes);
  if (!decoded) {
    CHECK(!decoded.error().message.empty() && decoded.error().message.size() < 400);
    return 0;
  }
  CHECK(decoded->Channels() >= 1 && decoded->Channels() <= 4);

  // What was read is written and read again without loss.
  std::visit(
      [&]<class T>(const Raster<T>& pixels) {
        const auto bytes = EncodePng(pixels);
        CHECK(bytes.ok());
        const auto again = DecodePng(*bytes, nullptr, kMostBytes);
        CHECK(again.ok() && std::get<Raster<T>>(again->pixels) == pixels);
      },
      decoded->pixels);
  return 0;
}
