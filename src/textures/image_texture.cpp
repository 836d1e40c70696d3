#include "textures/image_texture.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "base/parallel.h"
#include "base/text.h"
#include "image/image_file.h"
#include "image/tone_curve.h"
#include "math/elementary.h"

namespace candela {
namespace {

/// Three channels: grey stands for all of them, alpha is left out. What is no finite number is 0,
/// and counted.
Image ToColours(const Image& image, bool is_srgb, int64_t* not_finite) {
  Image colours(image.Width(), image.Height(), 3);
  std::atomic<int64_t> count = 0;
  const int step = image.Channels() > 2 ? 1 : 0;
  ParallelFor(image.Height(), [&](int64_t row) {
    const int y = static_cast<int>(row);
    for (int x = 0; x < image.Width(); ++x) {
      for (int c = 0; c < 3; ++c) {
        const float value = image.At(x, y, c * step);
        const bool is_finite = std::isfinite(value);
        if (!is_finite && c <= 2 * step) ++count;
        const float finite = is_finite ? value : 0;
        colours.At(x, y, c) = is_srgb ? LinearFromSrgb(finite) : finite;
      }
    }
  });
  *not_finite = count;
  return colours;
}

/// A picture for which there is memory in the form in which it is looked up: three floats a texel,
/// and a third as many texels again in its smaller copies.
Result<Image> ReadForLookup(const std::filesystem::path& path, std::vector<std::string>* warnings) {
  Result<Image> image = ReadImage(path, warnings);
  if (!image) return image;
  constexpr int64_t kBytesPerTexel = 16;
  if (const auto fits = CheckImageSize(image->Width(), image->Height(), kBytesPerTexel); !fits) {
    return fits.error();
  }
  return image;
}

constexpr std::string_view kEncodings[] = {"srgb", "linear"};
constexpr std::string_view kWraps[] = {"repeat", "mirror", "clamp"};

}  // namespace

std::shared_ptr<const Texture> ImageTexture::Create(ParamReader* params,
                                                    const TextureContext& context) {
  const ParamWord name = params->RequiredPath("file");
  const std::filesystem::path path = context.find_file(name);
  // Eight bits are made for eyes, and so for the curve; the others hold light.
  const bool is_for_eyes = IsForDisplays(FormatOf(path).value_or(ImageFormat::kPng));
  const bool is_srgb = params->Choice("encoding", kEncodings, is_for_eyes ? 0 : 1) == 0;
  const auto wrap = static_cast<Wrap>(params->Choice("wrap", kWraps, 0));
  const UvTransform transform = UvTransform::Create(params);
  if (name.text.empty()) return nullptr;

  std::vector<std::string> warnings;
  const Result<Image> image = ReadForLookup(path, &warnings);
  const SourceLocation file{std::make_shared<const std::string>(path.string())};
  for (std::string& warning : warnings) context.diagnostics->Warning(file, std::move(warning));
  if (!image) {
    context.diagnostics->Error(
        name.where, fmt::format("texture {}: {}", Quote(path.string()), image.error().message),
        image.error().code);
    return nullptr;
  }
  int64_t not_finite = 0;
  Image colours = ToColours(*image, is_srgb, &not_finite);
  if (not_finite > 0) {
    const bool is_one = not_finite == 1;
    context.diagnostics->Warning(
        file, fmt::format("{} value{} of the texture became 0; {} not {}finite number{}",
                          not_finite, is_one ? "" : "s", is_one ? "it was" : "they were",
                          is_one ? "a " : "", is_one ? "" : "s"));
  }
  return std::make_shared<ImageTexture>(MipMap(std::move(colours), wrap), transform);
}

Rgb ImageTexture::Lookup(const SurfacePoint& point) const {
  float width = 0;
  if (point.footprint > 0) {
    // The width on the surface, in texture coordinates of the direction that moves fastest.
    const auto across = [&](Vec3 dp, Vec2 d) {
      const float length = Length(dp);
      const Vec2 moved = transform_.Vector(d);
      return length > 0 ? std::max(std::abs(moved.x), std::abs(moved.y)) / length : 0;
    };
    width = point.footprint * std::max(across(point.dpdu, {1, 0}), across(point.dpdv, {0, 1}));
  }
  return picture_.Lookup(transform_.Apply(point.uv), width);
}

}  // namespace candela
