#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <functional>

#include "base/text.h"
#include "image/exr.h"
#include "image/exr_context.h"

namespace candela {
namespace {

constexpr int kPart = 0;

Error Wrong(std::string text) {
  return {ErrorCode::kInput, std::move(text)};
}

int64_t ReadBytes(exr_const_context_t, void* user_data, void* buffer, uint64_t size,
                  uint64_t offset, exr_stream_error_func_ptr_t) {
  const std::string_view& bytes = *static_cast<std::string_view*>(user_data);
  if (offset >= bytes.size()) return 0;
  const size_t count = std::min<uint64_t>(size, bytes.size() - offset);
  std::memcpy(buffer, bytes.data() + offset, count);
  return static_cast<int64_t>(count);
}

int64_t SizeOfBytes(exr_const_context_t, void* user_data) {
  return static_cast<int64_t>(static_cast<std::string_view*>(user_data)->size());
}

/// Unpacks the blocks of a file one after the other into the channels of a picture. The library
/// writes every channel of a block into a plane of its own. It could also write pixels and leave
/// channels out, but version 3.1 mixes up or crashes on four channels of halves then.
class BlockReader {
 public:
  /// `slots` says for each channel of the file which channel of `image` takes it; -1 leaves it out.
  BlockReader(exr_context_t context, std::vector<int> slots, Image* image)
      : context_(context), slots_(std::move(slots)), image_(*image) {}
  ~BlockReader() { exr_decoding_destroy(context_, &pipeline_); }
  BlockReader(const BlockReader&) = delete;
  BlockReader& operator=(const BlockReader&) = delete;

  /// (x, y) is the place of the block's first pixel in the picture.
  exr_result_t Read(const exr_chunk_info_t& block, int64_t x, int64_t y) {
    if (block.width < 1 || block.height < 1 || x + block.width > image_.Width() ||
        y + block.height > image_.Height()) {
      return EXR_ERR_BAD_CHUNK_LEADER;
    }
    exr_result_t code = is_first_ ? exr_decoding_initialize(context_, kPart, &block, &pipeline_)
                                  : exr_decoding_update(context_, kPart, &block, &pipeline_);
    if (code != EXR_ERR_SUCCESS) return code;
    const size_t plane = static_cast<size_t>(block.width) * static_cast<size_t>(block.height);
    planes_.resize(plane * slots_.size());
    for (size_t c = 0; c < slots_.size(); ++c) {
      exr_coding_channel_info_t& channel = pipeline_.channels[c];
      channel.user_bytes_per_element = sizeof(float);
      channel.user_data_type = EXR_PIXEL_FLOAT;
      channel.user_pixel_stride = sizeof(float);
      channel.user_line_stride = block.width * static_cast<int32_t>(sizeof(float));
      channel.decode_to_ptr = reinterpret_cast<uint8_t*>(planes_.data() + plane * c);
    }
    if (is_first_) code = exr_decoding_choose_default_routines(context_, kPart, &pipeline_);
    is_first_ = false;
    if (code == EXR_ERR_SUCCESS) code = exr_decoding_run(context_, kPart, &pipeline_);
    if (code == EXR_ERR_SUCCESS) Interleave(block, static_cast<int>(x), static_cast<int>(y));
    return code;
  }

 private:
  void Interleave(const exr_chunk_info_t& block, int x, int y) {
    const float* from = planes_.data();
    for (const int slot : slots_) {
      for (int row = 0; row < block.height; ++row, from += block.width) {
        if (slot < 0) continue;
        float* to = image_.Pixel(x, y + row).data() + slot;
        for (int i = 0; i < block.width; ++i) to[i * int64_t{image_.Channels()}] = from[i];
      }
    }
  }

  exr_context_t context_;
  std::vector<int> slots_;
  Image& image_;
  std::vector<float> planes_;
  exr_decode_pipeline_t pipeline_{};
  bool is_first_ = true;
};

exr_result_t ReadScanlines(exr_context_t context, const exr_attr_box2i_t& window, int height,
                           BlockReader* reader) {
  int32_t step = 0;
  exr_result_t code = exr_get_scanlines_per_chunk(context, kPart, &step);
  if (code == EXR_ERR_SUCCESS && step < 1) code = EXR_ERR_BAD_CHUNK_LEADER;
  for (int64_t y = 0; code == EXR_ERR_SUCCESS && y < height; y += step) {
    exr_chunk_info_t block;
    code = exr_read_scanline_chunk_info(context, kPart, static_cast<int>(window.min.y + y), &block);
    if (code == EXR_ERR_SUCCESS) code = reader->Read(block, 0, y);
  }
  return code;
}

exr_result_t ReadTiles(exr_context_t context, int width, int height, BlockReader* reader) {
  int32_t tile_width = 0, tile_height = 0;
  exr_result_t code = exr_get_tile_sizes(context, kPart, 0, 0, &tile_width, &tile_height);
  if (code == EXR_ERR_SUCCESS && (tile_width < 1 || tile_height < 1))
    code = EXR_ERR_BAD_CHUNK_LEADER;
  for (int64_t y = 0; code == EXR_ERR_SUCCESS && y < height; y += tile_height) {
    for (int64_t x = 0; code == EXR_ERR_SUCCESS && x < width; x += tile_width) {
      exr_chunk_info_t block;
      code = exr_read_tile_chunk_info(context, kPart, static_cast<int>(x / tile_width),
                                      static_cast<int>(y / tile_height), 0, 0, &block);
      if (code == EXR_ERR_SUCCESS) code = reader->Read(block, x, y);
    }
  }
  return code;
}

using Names = std::vector<std::string>;
/// Picks among the channels of a file those to read, in the order wanted.
using Choice = std::function<Result<Names>(const Names&)>;

Result<Names> ChooseColours(const Names& available) {
  const auto has = [&](const char* name) {
    return std::find(available.begin(), available.end(), name) != available.end();
  };
  Names wanted;
  if (has("R") && has("G") && has("B")) {
    wanted = {"R", "G", "B"};
  } else if (has("Y")) {
    wanted = {"Y"};
  } else if (available.size() == 1) {
    return available;
  } else {
    return Wrong("there is neither a set of channels R, G, B nor a channel Y");
  }
  if (has("A")) wanted.push_back("A");
  return wanted;
}

/// The picture must be worth its memory: each block has at least its place in a table (8 bytes) and
/// a head of 8 bytes, and holds a limited number of lines.
Result<void> CheckBlocks(exr_context_t context, size_t file_size) {
  int32_t blocks = 0;
  const exr_result_t code = exr_get_chunk_count(context, kPart, &blocks);
  if (code != EXR_ERR_SUCCESS) return Wrong(ExrMessage(code));
  if (blocks < 1 || static_cast<uint64_t>(blocks) * 16 > file_size) {
    return Wrong(fmt::format("{} blocks do not fit into a file of {} bytes", blocks, file_size));
  }
  return {};
}

Result<ExrPicture> Read(std::string_view bytes, int64_t most_bytes, const Choice& choose) {
  exr_context_initializer_t init = EXR_DEFAULT_CONTEXT_INITIALIZER;
  init.error_handler_fn = &IgnoreExrMessage;
  init.user_data = &bytes;
  init.read_fn = &ReadBytes;
  init.size_fn = &SizeOfBytes;
  init.flags = EXR_CONTEXT_FLAG_STRICT_HEADER | EXR_CONTEXT_FLAG_SILENT_HEADER_PARSE |
               EXR_CONTEXT_FLAG_DISABLE_CHUNK_RECONSTRUCTION;
  ExrContext context;
  exr_result_t code = exr_start_read(&context.handle, "memory", &init);
  if (code != EXR_ERR_SUCCESS) return Wrong(ExrMessage(code));

  exr_storage_t storage = EXR_STORAGE_LAST_TYPE;
  const exr_attr_chlist_t* list = nullptr;
  exr_attr_box2i_t window{};
  exr_compression_t compression = EXR_COMPRESSION_NONE;
  code = exr_get_storage(context.handle, kPart, &storage);
  if (code == EXR_ERR_SUCCESS) code = exr_get_channels(context.handle, kPart, &list);
  if (code == EXR_ERR_SUCCESS) code = exr_get_compression(context.handle, kPart, &compression);
  if (code == EXR_ERR_SUCCESS) code = exr_get_data_window(context.handle, kPart, &window);
  if (code != EXR_ERR_SUCCESS) return Wrong(ExrMessage(code));
  if (storage != EXR_STORAGE_SCANLINE && storage != EXR_STORAGE_TILED) {
    return Wrong("deep pixels are not supported");
  }
  if (list->num_channels < 1) return Wrong("there are no channels");
  if (compression == EXR_COMPRESSION_DWAA || compression == EXR_COMPRESSION_DWAB) {
    return Wrong("the compressions DWAA and DWAB are not supported");
  }

  const int64_t width = int64_t{window.max.x} - window.min.x + 1;
  const int64_t height = int64_t{window.max.y} - window.min.y + 1;
  const int64_t pixel_bytes = int64_t{list->num_channels} * int64_t{sizeof(float)};
  Result<void> fits = CheckImageSize(width, height, pixel_bytes, most_bytes);
  if (!fits) return fits.error();
  if (width * pixel_bytes > INT32_MAX) return Wrong("the rows are too long");
  if (storage == EXR_STORAGE_TILED) {
    int32_t tile_width = 0, tile_height = 0;
    code = exr_get_tile_sizes(context.handle, kPart, 0, 0, &tile_width, &tile_height);
    if (code != EXR_ERR_SUCCESS) return Wrong(ExrMessage(code));
    fits = CheckImageSize(tile_width, tile_height, pixel_bytes, most_bytes);
    if (!fits) return fits.error();
  }
  fits = CheckBlocks(context.handle, bytes.size());
  if (!fits) return fits.error();

  Names available;
  for (int c = 0; c < list->num_channels; ++c) {
    const exr_attr_chlist_entry_t& entry = list->entries[c];
    available.emplace_back(entry.name.str, static_cast<size_t>(entry.name.length));
    if (entry.x_sampling != 1 || entry.y_sampling != 1) {
      return Wrong(fmt::format("the channel {} is subsampled, which is not supported",
                               Quote(available.back())));
    }
  }
  Result<Names> wanted = choose(available);
  if (!wanted) return wanted.error();
  std::vector<int> slots;
  for (const std::string& name : available) {
    const auto found = std::find(wanted->begin(), wanted->end(), name);
    slots.push_back(found == wanted->end() ? -1 : static_cast<int>(found - wanted->begin()));
  }

  ExrPicture picture{
      Image(static_cast<int>(width), static_cast<int>(height), static_cast<int>(wanted->size())),
      *std::move(wanted)};
  BlockReader reader(context.handle, std::move(slots), &picture.image);
  code = storage == EXR_STORAGE_TILED
             ? ReadTiles(context.handle, picture.image.Width(), picture.image.Height(), &reader)
             : ReadScanlines(context.handle, window, picture.image.Height(), &reader);
  if (code != EXR_ERR_SUCCESS) return Wrong(ExrMessage(code));
  return picture;
}

}  // namespace

Result<Image> DecodeExr(std::string_view bytes, int64_t most_bytes) {
  Result<ExrPicture> picture = Read(bytes, most_bytes, &ChooseColours);
  if (!picture) return picture.error();
  return std::move(picture->image);
}

Result<ExrPicture> DecodeExrChannels(std::string_view bytes, int64_t most_bytes) {
  return Read(bytes, most_bytes, [](const Names& all) { return Result<Names>(all); });
}

}  // namespace candela
