#include "textures/cube_map.h"

#include <fmt/format.h>

#include <memory>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "base/files.h"
#include "base/parallel.h"
#include "base/text.h"
#include "image/png_read.h"

namespace candela {
namespace {

constexpr const char* kFileNames[] = {"left.png", "right.png", "up.png",
                                      "down.png", "front.png", "back.png"};

template <class T>
Raster<T> ToThreeChannels(Raster<T> image) {
  if (image.Channels() == 3) return image;
  Raster<T> rgb(image.Width(), image.Height(), 3);
  const int step = image.Channels() > 2 ? 1 : 0;  // Grey stands for all three.
  for (int y = 0; y < image.Height(); ++y) {
    for (int x = 0; x < image.Width(); ++x) {
      for (int c = 0; c < 3; ++c) rgb.At(x, y, c) = image.At(x, y, c * step);
    }
  }
  return rgb;
}

/// The texels around (u, v), both from 0 to 1 with v upwards, weighted by their distance. There is
/// no shift by half a texel, as in the course.
template <class T>
Rgb Blend(const Raster<T>& face, float u, float v) {
  constexpr float kScale = 1.0f / std::numeric_limits<T>::max();
  const float x = u * static_cast<float>(face.Width());
  const float y = (1 - v) * static_cast<float>(face.Height());
  const int x0 = x > 0 ? static_cast<int>(x) : 0;  // A NaN is not to be converted.
  const int y0 = y > 0 ? static_cast<int>(y) : 0;
  const float fx = x - static_cast<float>(x0);
  const float fy = y - static_cast<float>(y0);
  const auto texel = [&](int column, int row) {
    const T* t = &face.At(std::min(column, face.Width() - 1), std::min(row, face.Height() - 1));
    return Rgb{static_cast<float>(t[0]), static_cast<float>(t[1]), static_cast<float>(t[2])};
  };
  const Rgb top = texel(x0, y0) * (1 - fx) + texel(x0 + 1, y0) * fx;
  const Rgb bottom = texel(x0, y0 + 1) * (1 - fx) + texel(x0 + 1, y0 + 1) * fx;
  return (top * (1 - fy) + bottom * fy) * kScale;
}

}  // namespace

std::vector<std::filesystem::path> CubeMap::FaceFiles(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> paths;
  for (const char* name : kFileNames) paths.push_back(folder / name);
  return paths;
}

std::optional<CubeMap> CubeMap::Load(const std::filesystem::path& folder,
                                     const SourceLocation& asked, Diagnostics* diagnostics) {
  std::error_code error;
  if (!std::filesystem::is_directory(folder, error)) {
    diagnostics->Error(asked, fmt::format("cube map {}: no such folder", Quote(folder.string())));
    return std::nullopt;
  }
  CubeMap map;
  const std::vector<std::filesystem::path> paths = FaceFiles(folder);
  std::array<Diagnostics, kFaces> found;  // One for each task, so that the order stays fixed.
  ParallelFor(kFaces, [&](int64_t i) {
    const auto face = static_cast<size_t>(i);
    const std::filesystem::path& path = paths[face];
    const Result<std::string> bytes = ReadFile(path);
    if (!bytes) {
      found[face].Error(
          asked, fmt::format("cube map face {}: {}", Quote(path.string()), bytes.error().message),
          bytes.error().code);
      return;
    }
    const SourceLocation file{std::make_shared<const std::string>(path.string())};
    std::vector<std::string> warnings;
    Result<PngImage> png = DecodePng(*bytes, &warnings);
    for (std::string& warning : warnings) found[face].Warning(file, std::move(warning));
    if (!png) {
      found[face].Error(file, png.error().message, png.error().code);
      return;
    }
    map.faces_[face] = std::visit(
        [](auto& pixels) -> Face { return ToThreeChannels(std::move(pixels)); }, png->pixels);
  });
  bool is_complete = true;
  for (const Diagnostics& each : found) {
    is_complete = is_complete && !each.HasErrors();
    diagnostics->Append(each);
  }
  if (!is_complete) return std::nullopt;
  return map;
}

Rgb CubeMap::Lookup(Vec3 d) const {
  const int axis = LargestAxis(d);
  const float m = std::abs(d[axis]);
  FaceIndex face;
  float u, v;
  if (axis == 0) {
    face = d.x > 0 ? kRight : kLeft;
    u = d.x > 0 ? (1 + d.z / m) / 2 : (1 - d.z / m) / 2;
    v = (1 + d.y / m) / 2;
  } else if (axis == 1) {
    face = d.y > 0 ? kUp : kDown;
    u = (1 + d.x / m) / 2;
    v = (1 + d.z / m) / 2;
  } else {
    face = d.z > 0 ? kFront : kBack;
    u = (1 - d.x / m) / 2;
    v = (1 + d.y / m) / 2;
  }
  return std::visit([u, v](const auto& texels) { return Blend(texels, u, v); }, faces_[face]);
}

uint64_t CubeMap::MemoryBytes() const {
  uint64_t bytes = 0;
  for (const Face& face : faces_) {
    bytes += std::visit([](const auto& texels) { return texels.Samples().size_bytes(); }, face);
  }
  return bytes;
}

}  // namespace candela
