// The PNG reader. A mutator of its own repairs the checksums, without which hardly an input would
// come past the first chunk, and now and then changes the scanlines inside the compressed data.
#include <zlib.h>

#include <algorithm>
#include <cstring>
#include <string>
#include <string_view>

#include "base/check.h"
#include "image/png_chunks.h"
#include "image/png_read.h"
#include "image/png_write.h"

extern "C" size_t LLVMFuzzerMutate(uint8_t* data, size_t size, size_t max_size);

namespace {

constexpr int64_t kMostBytes = 1 << 22;
constexpr size_t kMostScanlines = 1 << 16;

void PutBigEndian32(uint32_t value, char* to) {
  for (int shift = 24; shift >= 0; shift -= 8) *to++ = static_cast<char>(value >> shift);
}

const Bytef* Unsigned(const char* bytes) {
  return reinterpret_cast<const Bytef*>(bytes);
}

/// Sets the checksum of each chunk that is there as a whole.
void RepairChecksums(std::string* file) {
  for (size_t at = 8; file->size() - std::min(at, file->size()) >= 12;) {
    char* chunk = file->data() + at;
    size_t length = 0;
    for (size_t i = 0; i < 4; ++i) length = length << 8 | static_cast<uint8_t>(chunk[i]);
    if (length > file->size() - at - 12) return;
    PutBigEndian32(static_cast<uint32_t>(crc32_z(0, Unsigned(chunk + 4), length + 4)),
                   chunk + 8 + length);
    at += length + 12;
  }
}

/// Changes the unpacked data of a sound file and packs it again into one chunk. False when there is
/// nothing to unpack.
bool MutateScanlines(std::string* file) {
  const auto png = candela::ReadPngChunks(*file, nullptr);
  if (!png) return false;
  std::string packed;
  for (const std::string_view piece : png->data) packed += piece;
  std::string scanlines(kMostScanlines, '\0');
  uLongf size = scanlines.size();
  auto* out = reinterpret_cast<Bytef*>(scanlines.data());
  uncompress(out, &size, Unsigned(packed.data()),
             packed.size());  // What came before an error, too.
  size = LLVMFuzzerMutate(out, std::min<size_t>(size, kMostScanlines / 2), kMostScanlines);

  uLongf bound = compressBound(size);
  std::string chunk(bound + 12, '\0');
  if (compress2(reinterpret_cast<Bytef*>(chunk.data() + 8), &bound, out, size, 1) != Z_OK) {
    return false;
  }
  chunk.resize(bound + 12);
  PutBigEndian32(static_cast<uint32_t>(bound), chunk.data());
  std::memcpy(chunk.data() + 4, "IDAT", 4);
  const auto first_data = static_cast<size_t>(png->data[0].data() - file->data()) - 8;
  constexpr std::string_view kEnd("\0\0\0\0IEND\0\0\0\0", 12);
  file->resize(first_data);
  file->append(chunk).append(kEnd);
  return true;
}

}  // namespace

extern "C" size_t LLVMFuzzerCustomMutator(uint8_t* data, size_t size, size_t max_size,
                                          unsigned seed) {
  std::string file(reinterpret_cast<const char*>(data), size);
  if (seed % 4 != 0 || !MutateScanlines(&file)) {
    file.resize(max_size);
    file.resize(LLVMFuzzerMutate(reinterpret_cast<uint8_t*>(file.data()), size, max_size));
  }
  if (seed % 16 != 1) RepairChecksums(&file);
  if (file.size() > max_size) file.resize(max_size);
  std::memcpy(data, file.data(), file.size());
  return file.size();
}

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  using namespace candela;
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  std::vector<std::string> warnings;
  const Result<PngImage> png = DecodePng(bytes, &warnings, kMostBytes);
  if (!png) {
    CHECK(!png.error().message.empty());
    return 0;
  }
  std::visit(
      [](const auto& image) {
        CHECK(!image.IsEmpty() && static_cast<int64_t>(image.Samples().size_bytes()) <= kMostBytes);
        if (image.PixelCount() > 4096) return;
        const Result<std::string> file = EncodePng(image);
        CHECK(file.ok());
        std::vector<std::string> none;
        const Result<PngImage> again = DecodePng(*file, &none);
        CHECK(again.ok() && none.empty());
        CHECK(std::get<std::decay_t<decltype(image)>>(again->pixels) == image);
      },
      png->pixels);
  return 0;
}
