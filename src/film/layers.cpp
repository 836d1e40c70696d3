#include "film/layers.h"

#include <bit>
#include <cstring>

#include "film/pixel_estimate.h"
#include "math/exact_sum.h"
#include "math/float4.h"

namespace candela {
namespace {

// What compositors that others write for take for nothing: far away, but a number that can be
// shown. Infinity spoils every filter that it gets into.
constexpr float kDepthOfNothing = 1e10f;

/// The mean light of the pixel that was scattered so often.
Rgb MeanLight(const PixelEstimate& pixel, size_t times_scattered) {
  return pixel.Mean([=](const PixelPart& part) { return part.layers->Light(times_scattered); });
}

Float4 UsableInLayers(Float4 any) {
  const Float4 largest = Broadcast(ExactSum::kLargestTerm);
  const Float4 limited = Min(Max(any, -largest), largest);
  return any == any ? limited : Float4{};
}

void Put(Vec3 value, uint32_t* words) {
  words[0] = std::bit_cast<uint32_t>(value.x);
  words[1] = std::bit_cast<uint32_t>(value.y);
  words[2] = std::bit_cast<uint32_t>(value.z);
}

constexpr LayerEntry kLayers[] = {
    {"depth", "Z", false, "distance along the camera's view, 1e10 where nothing is",
     [](const PixelEstimate& pixel, uint32_t* words) {
       const SampleLayers::Surface& seen = pixel.Nearest().Surface();
       *words = std::bit_cast<uint32_t>(seen.object == 0 ? kDepthOfNothing : seen.depth);
     }},
    {"position", "XYZ", false, "point in the world",
     [](const PixelEstimate& pixel, uint32_t* words) {
       Put(pixel.Nearest().Surface().position, words);
     }},
    {"normal", "XYZ", false, "normal as shaded, in the world, towards the camera",
     [](const PixelEstimate& pixel, uint32_t* words) {
       Put(pixel.Nearest().Surface().n_shading, words);
     }},
    {"geometric_normal", "XYZ", false, "normal of the true surface",
     [](const PixelEstimate& pixel, uint32_t* words) {
       Put(pixel.Nearest().Surface().n_geometric, words);
     }},
    {"albedo", "RGB", false, "part of white light that the surface gives back",
     [](const PixelEstimate& pixel, uint32_t* words) {
       Put(pixel.Mean([](const PixelPart& part) { return part.layers->Albedo(); }), words);
     }},
    {"uv", "UV", false, "texture coordinates",
     [](const PixelEstimate& pixel, uint32_t* words) {
       words[0] = std::bit_cast<uint32_t>(pixel.Nearest().Surface().uv.x);
       words[1] = std::bit_cast<uint32_t>(pixel.Nearest().Surface().uv.y);
     }},
    {"object_id", "X", true, "number of the object from 1 on, 0 where nothing is",
     [](const PixelEstimate& pixel, uint32_t* words) {
       *words = pixel.Nearest().Surface().object;
     }},
    {"material_id", "X", true, "number of the material, the same way",
     [](const PixelEstimate& pixel, uint32_t* words) {
       *words = pixel.Nearest().Surface().material;
     }},
    {"direct", "RGB", false, "light scattered once",
     [](const PixelEstimate& pixel, uint32_t* words) { Put(MeanLight(pixel, 1), words); }},
    {"indirect", "RGB", false, "light scattered more often",
     [](const PixelEstimate& pixel, uint32_t* words) { Put(MeanLight(pixel, 2), words); }},
    {"emission", "RGB", false, "lamps and sky as the camera sees them",
     [](const PixelEstimate& pixel, uint32_t* words) { Put(MeanLight(pixel, 0), words); }},
    {"sample_count", "X", true, "samples that count",
     [](const PixelEstimate& pixel, uint32_t* words) { *words = pixel.SampleCount(); }},
    {"standard_error", "RGB", false, "standard error of the colour",
     [](const PixelEstimate& pixel, uint32_t* words) { Put(pixel.StandardError(), words); }},
    {"light_groups", "RGB", false, "the light of each group of lights (path and direct)",
     [](const PixelEstimate& pixel, uint32_t* words) {
       for (size_t i = 0; i < pixel.LightGroupCount(); ++i) {
         Put(pixel.Mean([=](const PixelPart& part) { return part.light_groups[i]; }),
             words + 3 * i);
       }
     },
     true},
};

}  // namespace

Vec3d UsableInLayers(Rgb value) {
  return ToDouble(ToVec3(UsableInLayers(ToFloat4(value))));
}

std::span<const LayerEntry, kLayerCount> Layers() {
  return kLayers;
}

bool PixelLayers::IsNearest(float distance, uint32_t index) {
  const bool is_nearest =
      !has_nearest_ || distance < distance_ || (distance == distance_ && index < index_);
  if (is_nearest) {
    has_nearest_ = true;
    distance_ = distance;
    index_ = index;
  }
  return is_nearest;
}

bool PixelLayers::IsNearerThan(const PixelLayers& other) const {
  return has_nearest_ && (!other.has_nearest_ || distance_ < other.distance_);
}

void PixelLayers::Add(const SampleLayers& sample, float weight) {
  const SampleColours& colours = sample;
  const auto fours = std::bit_cast<std::array<Float4, 3>>(colours);
  for (size_t i = 0; i < fours.size(); ++i) {
    Double4 sum;  // By copying: the sums need not lie where vectors may.
    std::memcpy(&sum, &sums_[4 * i], sizeof sum);
    sum += __builtin_convertvector(UsableInLayers(fours[i] * weight), Double4);
    std::memcpy(&sums_[4 * i], &sum, sizeof sum);
  }
}

}  // namespace candela
