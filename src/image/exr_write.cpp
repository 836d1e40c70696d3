#include <algorithm>
#include <cstring>
#include <new>

#include "image/exr.h"
#include "image/exr_context.h"

namespace candela {
namespace {

// Level 1 of zlib: files of layers are 4 percent larger than with level 4, in two thirds of the
// time.
constexpr int kZipLevel = 1;
constexpr int kSampleBytes = 4;

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

exr_pixel_type_t TypeOf(const ExrChannel& channel) {
  return channel.is_whole ? EXR_PIXEL_UINT : EXR_PIXEL_FLOAT;
}

/// A picture in memory.
struct Source {
  int width, height;
  std::span<const ExrChannel> channels;
};

exr_result_t WriteHeader(exr_context_t context, const Source& source,
                         std::span<const ExrAttribute> attributes) {
  // Said in the header, so only where it is needed: old readers do not know such files.
  constexpr size_t kShortName = 31;
  const bool has_long_names = std::ranges::any_of(
      source.channels, [](const ExrChannel& channel) { return channel.name.size() > kShortName; });
  exr_result_t code = exr_set_longname_support(context, has_long_names ? 1 : 0);
  int part = 0;
  if (code == EXR_ERR_SUCCESS) {
    code = exr_add_part(context, nullptr, EXR_STORAGE_SCANLINE, &part);
  }
  if (code == EXR_ERR_SUCCESS) {
    code = exr_initialize_required_attr_simple(context, part, source.width, source.height,
                                               EXR_COMPRESSION_ZIP);
  }
  if (code == EXR_ERR_SUCCESS) code = exr_set_zip_compression_level(context, part, kZipLevel);
  for (const ExrChannel& channel : source.channels) {
    if (code != EXR_ERR_SUCCESS) break;
    code = exr_add_channel(context, part, channel.name.c_str(), TypeOf(channel),
                           EXR_PERCEPTUALLY_LOGARITHMIC, 1, 1);
  }
  for (const ExrAttribute& attribute : attributes) {
    if (code != EXR_ERR_SUCCESS) break;
    code = exr_attr_set_string(context, part, attribute.name.c_str(), attribute.value.c_str());
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

exr_result_t WriteBlocks(exr_context_t context, const Source& source) {
  int32_t step = 0;
  exr_result_t code = exr_get_scanlines_per_chunk(context, 0, &step);
  exr_encode_pipeline_t pipeline{};
  Compressor compressor{};
  for (int y = 0; code == EXR_ERR_SUCCESS && y < source.height; y += step) {
    exr_chunk_info_t block;
    code = exr_write_scanline_chunk_info(context, 0, y, &block);
    if (code != EXR_ERR_SUCCESS) break;
    code = y == 0 ? exr_encoding_initialize(context, 0, &block, &pipeline)
                  : exr_encoding_update(context, 0, &block, &pipeline);
    if (code != EXR_ERR_SUCCESS) break;
    for (int c = 0; c < pipeline.channel_count; ++c) {
      // The library keeps the channels in alphabetical order, whatever the order they came in.
      exr_coding_channel_info_t& channel = pipeline.channels[c];
      const ExrChannel& from =
          *std::ranges::find(source.channels, channel.channel_name, &ExrChannel::name);
      const int row = source.width * from.stride * kSampleBytes;
      channel.user_bytes_per_element = kSampleBytes;
      channel.user_data_type = TypeOf(from);
      channel.user_pixel_stride = from.stride * kSampleBytes;
      channel.user_line_stride = row;
      channel.encode_from_ptr =
          static_cast<const uint8_t*>(from.samples) + static_cast<ptrdiff_t>(y) * row;
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

Result<std::string> EncodeExr(int width, int height, std::span<const ExrChannel> channels,
                              std::span<const ExrAttribute> attributes) {
  if (width == 0 || height == 0) {
    return Error{ErrorCode::kUsage, "an EXR file holds at least one pixel"};
  }
  auto samples_per_pixel = static_cast<int64_t>(channels.size());
  for (const ExrChannel& channel : channels) {
    samples_per_pixel = std::max(samples_per_pixel, int64_t{channel.stride});
  }
  if (width * samples_per_pixel * kSampleBytes > INT32_MAX) {
    return Error{ErrorCode::kResources, "the rows are too long for an EXR file"};
  }
  const Source source{width, height, channels};
  std::string file;
  exr_context_initializer_t init = EXR_DEFAULT_CONTEXT_INITIALIZER;
  init.error_handler_fn = &IgnoreExrMessage;
  init.user_data = &file;
  init.write_fn = &AppendBytes;
  ExrContext context;
  exr_result_t code = exr_start_write(&context.handle, "memory", EXR_WRITE_FILE_DIRECTLY, &init);
  if (code == EXR_ERR_SUCCESS) code = WriteHeader(context.handle, source, attributes);
  if (code == EXR_ERR_SUCCESS) code = WriteBlocks(context.handle, source);
  // Closing writes the table of blocks, so its result counts.
  if (code == EXR_ERR_SUCCESS) code = exr_finish(&context.handle);
  if (code != EXR_ERR_SUCCESS) return Error{ErrorCode::kOutput, ExrMessage(code)};
  return file;
}

namespace {

Result<std::string> EncodeNamed(const Image& image, std::span<const std::string> names,
                                std::span<const ExrAttribute> attributes) {
  CHECK(static_cast<int>(names.size()) == image.Channels());
  std::vector<ExrChannel> channels;
  for (const std::string& name : names) {
    channels.push_back({name, false, image.Samples().data() + channels.size(), image.Channels()});
  }
  return EncodeExr(image.Width(), image.Height(), channels, attributes);
}

}  // namespace

Result<std::string> EncodeExr(const Image& image, std::span<const std::string> channels) {
  return EncodeNamed(image, channels, {});
}

Result<std::string> EncodeExr(const Image& image, std::span<const ExrAttribute> attributes) {
  static const std::string kGrey[] = {"Y", "A"};
  static const std::string kColour[] = {"R", "G", "B", "A"};
  CHECK(image.Channels() <= 4);
  const std::span<const std::string> names =
      image.Channels() <= 2 ? std::span<const std::string>(kGrey) : kColour;
  return EncodeNamed(image, names.first(static_cast<size_t>(image.Channels())), attributes);
}

}  // namespace candela
