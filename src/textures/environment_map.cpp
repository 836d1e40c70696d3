#include "textures/environment_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>

#include "base/files.h"
#include "base/text.h"
#include "image/channels.h"
#include "image/image_file.h"
#include "image/size_limit.h"
#include "textures/lat_long.h"

namespace candela {
namespace {

/// Reports what cannot be light. False when the picture is of no use.
bool MakeRadiance(const SourceLocation& file, Image* image, Diagnostics* diagnostics) {
  int64_t negative = 0;
  for (int y = 0; y < image->Height(); ++y) {
    for (int x = 0; x < image->Width(); ++x) {
      for (float& value : image->Pixel(x, y)) {
        if (!std::isfinite(value)) {
          diagnostics->Error(
              file, fmt::format("pixel ({}, {}) of the environment is not a finite number", x, y));
          return false;
        }
        if (value < 0) {
          ++negative;
          value = 0;
        }
      }
    }
  }
  if (negative > 0) {
    diagnostics->Warning(
        file, fmt::format("{} negative value{} of the environment became 0; there is no negative "
                          "light",
                          negative, negative == 1 ? "" : "s"));
  }
  return true;
}

}  // namespace

EnvironmentMap::EnvironmentMap(Image radiance, float scale, float rotate_degrees)
    : radiance_(std::move(radiance)), scale_(scale) {
  const double turn = double{rotate_degrees} / 360;
  turn_ = static_cast<float>(turn - std::floor(turn));
}

std::optional<EnvironmentMap> EnvironmentMap::Load(const std::filesystem::path& path,
                                                   const SourceLocation& asked, float scale,
                                                   float rotate_degrees, Diagnostics* diagnostics) {
  const Result<std::string> bytes = ReadFile(path);
  if (!bytes) {
    diagnostics->Error(
        asked, fmt::format("environment {}: {}", Quote(path.string()), bytes.error().message),
        bytes.error().code);
    return std::nullopt;
  }
  const SourceLocation file{std::make_shared<const std::string>(path.string())};
  std::vector<std::string> warnings;
  const Result<Image> decoded = DecodeImage(*bytes, &warnings);
  for (std::string& warning : warnings) diagnostics->Warning(file, std::move(warning));
  if (!decoded) {
    diagnostics->Error(file, decoded.error().message, decoded.error().code);
    return std::nullopt;
  }
  // Besides the colours there is a weight for each texel, and sums of these, to draw directions.
  constexpr int64_t kBytesPerTexel = 20;
  if (const auto fits = CheckImageSize(decoded->Width(), decoded->Height(), kBytesPerTexel);
      !fits) {
    diagnostics->Error(file, fits.error().message, fits.error().code);
    return std::nullopt;
  }
  Image radiance = WithChannels(*decoded, 3);
  if (!MakeRadiance(file, &radiance, diagnostics)) return std::nullopt;
  return EnvironmentMap(std::move(radiance), scale, rotate_degrees);
}

Rgb EnvironmentMap::Texel(int x, int y) const {
  const int width = radiance_.Width();
  const int column = x < 0 ? x + width : x >= width ? x - width : x;
  const int row = std::clamp(y, 0, radiance_.Height() - 1);
  const float* texel = &radiance_.At(column, row);
  return {texel[0], texel[1], texel[2]};
}

Rgb EnvironmentMap::Lookup(Vec3 direction) const {
  const Vec2 place = TurnLatLong(LatLongOf(direction), turn_);
  // The middles of texels are half a texel inside.
  const float x = place.x * static_cast<float>(radiance_.Width()) - 0.5f;
  const float y = place.y * static_cast<float>(radiance_.Height()) - 0.5f;
  const int x0 = static_cast<int>(std::floor(x)), y0 = static_cast<int>(std::floor(y));
  const float fx = x - static_cast<float>(x0), fy = y - static_cast<float>(y0);
  const Rgb top = Texel(x0, y0) * (1 - fx) + Texel(x0 + 1, y0) * fx;
  const Rgb bottom = Texel(x0, y0 + 1) * (1 - fx) + Texel(x0 + 1, y0 + 1) * fx;
  return (top * (1 - fy) + bottom * fy) * scale_;
}

std::vector<float> EnvironmentMap::MeansOfCells() const {
  const int width = radiance_.Width(), height = radiance_.Height();
  std::vector<float> means;
  means.reserve(static_cast<size_t>(radiance_.PixelCount()));
  const auto sum = [this](int x, int y) {
    const Rgb texel = Texel(x, y);
    return texel.x + texel.y + texel.z;
  };
  // Of a blend of texels with its neighbours, the integral over the cell of one takes 6/8 from it
  // and 1/8 from each side.
  const auto along_row = [&](int x, int y) {
    return 6 * sum(x, y) + sum(x - 1, y) + sum(x + 1, y);
  };
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const float mean = 6 * along_row(x, y) + along_row(x, y - 1) + along_row(x, y + 1);
      means.push_back(mean * scale_ * (1.0f / (3 * 64)));
    }
  }
  return means;
}

}  // namespace candela
