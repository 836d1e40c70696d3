#include "film/layers.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "film/film.h"

namespace candela {
namespace {

constexpr LayerSet kLightLayers{{Layer::kDirect, Layer::kIndirect, Layer::kEmission}};

// What compositors that others write for take for nothing: far away, but a number that can be
// shown. Infinity spoils every filter that it gets into.
constexpr float kDepthOfNothing = 1e10f;

void AddTo(std::array<ExactSum, 3>* sums, Rgb value) {
  if (value == Rgb()) return;  // Most samples have no light of one kind or another.
  // What is recorded may be infinite or no number where the radiance is neither: a colour of 0 can
  // hide it.
  const auto finite = [](float x) { return x == x ? x : 0; };
  (*sums)[0].Add(finite(value.x));
  (*sums)[1].Add(finite(value.y));
  (*sums)[2].Add(finite(value.z));
}

Rgb MeanOf(const std::array<ExactSum, 3>& sums, const PixelSums& pixel) {
  const double divisor = pixel.weight.ToDouble();
  if (divisor == 0) return {};
  return ToFloat(
      {sums[0].ToDouble() / divisor, sums[1].ToDouble() / divisor, sums[2].ToDouble() / divisor});
}

void Put(Vec3 value, uint32_t* words) {
  words[0] = std::bit_cast<uint32_t>(value.x);
  words[1] = std::bit_cast<uint32_t>(value.y);
  words[2] = std::bit_cast<uint32_t>(value.z);
}

constexpr LayerEntry kLayers[] = {
    {"depth", "Z", false, "distance along the camera's view, 1e10 where nothing is",
     [](const PixelLayers& l, const PixelSums&, uint32_t* words) {
       const SampleLayers::Surface& seen = l.Surface();
       *words = std::bit_cast<uint32_t>(seen.object == 0 ? kDepthOfNothing : seen.depth);
     }},
    {"position", "XYZ", false, "point in the world",
     [](const PixelLayers& l, const PixelSums&, uint32_t* words) {
       Put(l.Surface().position, words);
     }},
    {"normal", "XYZ", false, "normal as shaded, in the world, towards the camera",
     [](const PixelLayers& l, const PixelSums&, uint32_t* words) {
       Put(l.Surface().n_shading, words);
     }},
    {"geometric_normal", "XYZ", false, "normal of the true surface",
     [](const PixelLayers& l, const PixelSums&, uint32_t* words) {
       Put(l.Surface().n_geometric, words);
     }},
    {"albedo", "RGB", false, "part of white light that the surface gives back",
     [](const PixelLayers& l, const PixelSums& sums, uint32_t* words) {
       Put(l.MeanAlbedo(sums), words);
     }},
    {"uv", "UV", false, "texture coordinates",
     [](const PixelLayers& l, const PixelSums&, uint32_t* words) {
       words[0] = std::bit_cast<uint32_t>(l.Surface().uv.x);
       words[1] = std::bit_cast<uint32_t>(l.Surface().uv.y);
     }},
    {"object_id", "X", true, "number of the object from 1 on, 0 where nothing is",
     [](const PixelLayers& l, const PixelSums&, uint32_t* words) { *words = l.Surface().object; }},
    {"material_id", "X", true, "number of the material, the same way",
     [](const PixelLayers& l, const PixelSums&, uint32_t* words) {
       *words = l.Surface().material;
     }},
    {"direct", "RGB", false, "light scattered once",
     [](const PixelLayers& l, const PixelSums& sums, uint32_t* words) {
       Put(l.MeanLight(sums, 1), words);
     }},
    {"indirect", "RGB", false, "light scattered more often",
     [](const PixelLayers& l, const PixelSums& sums, uint32_t* words) {
       Put(l.MeanLight(sums, 2), words);
     }},
    {"emission", "RGB", false, "lamps and sky as the camera sees them",
     [](const PixelLayers& l, const PixelSums& sums, uint32_t* words) {
       Put(l.MeanLight(sums, 0), words);
     }},
    {"sample_count", "X", true, "samples that count",
     [](const PixelLayers& l, const PixelSums&, uint32_t* words) { *words = l.SampleCount(); }},
    {"standard_error", "RGB", false, "standard error of the colour",
     [](const PixelLayers& l, const PixelSums& sums, uint32_t* words) {
       Put(l.StandardError(sums), words);
     }},
};

}  // namespace

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

void PixelLayers::Add(LayerSet layers, const SampleLayers& sample, Rgb radiance, float weight) {
  ++count_;
  if (layers.Has(Layer::kAlbedo)) AddTo(&albedo_, sample.albedo * weight);
  if (layers.HasAny(kLightLayers)) {
    for (size_t i = 0; i < light_.size(); ++i) AddTo(&light_[i], sample.light[i] * weight);
  }
  if (layers.Has(Layer::kStandardError)) {
    const float square = weight * weight;
    AddTo(&squares_, radiance * radiance * square);
    if (weight != 1) {
      AddTo(&weighted_excess_, radiance * (square - weight));
      weight_excess_.Add(square - weight);
    }
  }
}

Rgb PixelLayers::MeanAlbedo(const PixelSums& sums) const {
  return MeanOf(albedo_, sums);
}

Rgb PixelLayers::MeanLight(const PixelSums& sums, size_t times_scattered) const {
  if (times_scattered < light_.size()) return MeanOf(light_[times_scattered], sums);
  const double divisor = sums.weight.ToDouble();
  if (divisor == 0) return {};
  const auto rest = [&](size_t i, const ExactSum& all) {
    return (all.ToDouble() - light_[0][i].ToDouble() - light_[1][i].ToDouble()) / divisor;
  };
  return ToFloat({rest(0, sums.red), rest(1, sums.green), rest(2, sums.blue)});
}

// The pixel is sum(w L) / sum(w). Its variance is n / (n - 1) times the sum of w^2 (L - mean)^2
// over the square of sum(w): W. Cochran, "Sampling techniques", 1977, for the mean of a ratio.
Rgb PixelLayers::StandardError(const PixelSums& sums) const {
  const double weight = sums.weight.ToDouble();
  if (count_ < 2 || weight == 0) return {};
  const double correction = static_cast<double>(count_) / (count_ - 1);
  const double weight_squares = weight + weight_excess_.ToDouble();
  const auto error = [&](size_t i, const ExactSum& sum) {
    const double mean = sum.ToDouble() / weight;
    const double weighted = sum.ToDouble() + weighted_excess_[i].ToDouble();
    const double spread =
        squares_[i].ToDouble() - 2 * mean * weighted + mean * mean * weight_squares;
    return std::sqrt(correction * std::max(0.0, spread)) / std::abs(weight);
  };
  return ToFloat({error(0, sums.red), error(1, sums.green), error(2, sums.blue)});
}

}  // namespace candela
