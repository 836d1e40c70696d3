#include <algorithm>
#include <cstring>
#include <new>

#include "image/exr.h"
#include "image/exr_context.h"

namespace candela {
namespace {

// Level 4 of zlib: most of what level 6 gains on float pictures, in half the time.
constexpr int kZipLevel = 4;

int64_t AppendBytes(exr_const_context_t, void* user_data, const void* buffer, uint64_t size,
                    uint64_t offset, exr_stream_error_func_ptr_t) {
  std::string& file = *static_cast<std::string*>(user_data);
  try {
    if (file.size() < offset + size) file.resize(offset + size);
  } catch (const std::bad_alloc&) {
    return -1;  // No exception may pass through the C library.
  }
  std::memcpy(file.data() + offset, buffer, size);
  return static_cast<int64_t>(size);
}

exr_result_t WriteHeader(exr_context_t context, const Image& image,
                         std::span<const std::string> channels) {
  int part = 0;
  exr_result_t code = exr_add_part(context, nullptr, EXR_STORAGE_SCANLINE, &part);
  if (code == EXR_ERR_SUCCESS) {
    code = exr_initialize_required_attr_simple(context, part, image.Width(), image.Height(),
                                               EXR_COMPRESSION_ZIP);
  }
  if (code == EXR_ERR_SUCCESS) code = exr_set_zip_compression_level(context, part, kZipLevel);
  for (const std::string& name : channels) {
    if (code != EXR_ERR_SUCCESS) break;
    code = exr_add_channel(context, part, name.c_str(), EXR_PIXEL_FLOAT,
                           EXR_PERCEPTUALLY_LOGARITHMIC, 1, 1);
  }
  return code == EXR_ERR_SUCCESS ? exr_write_header(context) : code;
}

/// Readers take a block whose packed size equals its plain size for plain data, but the library
/// (3.1) stores plain data only if packing made it larger. The wrapper covers the case between.
struct Compressor {
  exr_result_t (*original)(exr_encode_pipeline_t*);

  static exr_result_t Run(exr_encode_pipeline_t* pipeline) {
    const auto* self = static_cast<Compressor*>(pipeline->encoding_user_data);
    const exr_result_t code = self->original(pipeline);
    if (code == EXR_ERR_SUCCESS && pipeline->compressed_bytes == pipeline->packed_bytes) {
      std::memcpy(pipeline->compressed_buffer, pipeline->packed_buffer, pipeline->packed_bytes);
    }
    return code;
  }
};

exr_result_t WriteBlocks(exr_context_t context, const Image& image,
                         std::span<const std::string> channels) {
  int32_t step = 0;
  exr_result_t code = exr_get_scanlines_per_chunk(context, 0, &step);
  exr_encode_pipeline_t pipeline{};
  Compressor compressor{};
  for (int y = 0; code == EXR_ERR_SUCCESS && y < image.Height(); y += step) {
    exr_chunk_info_t block;
    code = exr_write_scanline_chunk_info(context, 0, y, &block);
    if (code != EXR_ERR_SUCCESS) break;
    code = y == 0 ? exr_encoding_initialize(context, 0, &block, &pipeline)
                  : exr_encoding_update(context, 0, &block, &pipeline);
    if (code != EXR_ERR_SUCCESS) break;
    for (int c = 0; c < pipeline.channel_count; ++c) {
      // The library keeps the channels in alphabetical order, whatever the order they came in.
      exr_coding_channel_info_t& channel = pipeline.channels[c];
      const auto found = std::find(channels.begin(), channels.end(), channel.channel_name);
      const float* first = image.Row(y).data() + (found - channels.begin());
      channel.user_bytes_per_element = sizeof(float);
      channel.user_data_type = EXR_PIXEL_FLOAT;
      channel.user_pixel_stride = image.Channels() * static_cast<int>(sizeof(float));
      channel.user_line_stride = static_cast<int32_t>(image.RowSize() * sizeof(float));
      channel.encode_from_ptr = reinterpret_cast<const uint8_t*>(first);
    }
    if (y == 0) {
      code = exr_encoding_choose_default_routines(context, 0, &pipeline);
      compressor.original = pipeline.compress_fn;
      pipeline.compress_fn = &Compressor::Run;
      pipeline.encoding_user_data = &compressor;
    }
    if (code == EXR_ERR_SUCCESS) code = exr_encoding_run(context, 0, &pipeline);
  }
  exr_encoding_destroy(context, &pipeline);
  return code;
}

}  // namespace

Result<std::string> EncodeExr(const Image& image, std::span<const std::string> channels) {
  CHECK(static_cast<int>(channels.size()) == image.Channels());
  if (image.IsEmpty()) return Error{ErrorCode::kUsage, "an EXR file holds at least one pixel"};
  if (image.RowSize() * sizeof(float) > INT32_MAX) {
    return Error{ErrorCode::kResources, "the rows are too long for an EXR file"};
  }
  std::string file;
  exr_context_initializer_t init = EXR_DEFAULT_CONTEXT_INITIALIZER;
  init.error_handler_fn = &IgnoreExrMessage;
  init.user_data = &file;
  init.write_fn = &AppendBytes;
  ExrContext context;
  exr_result_t code = exr_start_write(&context.handle, "memory", EXR_WRITE_FILE_DIRECTLY, &init);
  if (code == EXR_ERR_SUCCESS) code = WriteHeader(context.handle, image, channels);
  if (code == EXR_ERR_SUCCESS) code = WriteBlocks(context.handle, image, channels);
  // Closing writes the table of blocks, so its result counts.
  if (code == EXR_ERR_SUCCESS) code = exr_finish(&context.handle);
  if (code != EXR_ERR_SUCCESS) return Error{ErrorCode::kOutput, ExrMessage(code)};
  return file;
}

Result<std::string> EncodeExr(const Image& image) {
  static const std::string kGrey[] = {"Y", "A"};
  static const std::string kColour[] = {"R", "G", "B", "A"};
  CHECK(image.Channels() <= 4);
  const std::span<const std::string> names =
      image.Channels() <= 2 ? std::span<const std::string>(kGrey) : kColour;
  return EncodeExr(image, names.first(static_cast<size_t>(image.Channels())));
}

}  // namespace candela
