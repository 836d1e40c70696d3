#include "film/layers.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <set>
#include <string>
#include <vector>

#include "film/film.h"
#include "film/pixel_estimate.h"

namespace candela {
namespace {

SampleLayers Seen(uint32_t object, float depth) {
  SampleLayers sample;
  sample.surface.object = object;
  sample.surface.depth = depth;
  return sample;
}

/// One pixel with all layers.
struct OnePixel {
  void Add(const SampleLayers& sample, Rgb radiance, float weight, float distance, uint32_t index) {
    sums.Add(radiance, weight);
    spread.Add(radiance, weight);
    if (layers.IsNearest(distance, index)) layers.SetSurface(sample.surface);
    layers.Add(sample, weight);
  }
  PixelPart Part() const { return {&sums, &spread, &layers, {}, light_groups}; }
  PixelSums sums;
  PixelSpread spread;
  PixelLayers layers;
  std::vector<Vec3d> light_groups;
};

PixelEstimate EstimateOf(const OnePixel& pixel) {
  const PixelPart part = pixel.Part();
  return PixelEstimate({&part, 1});
}

Vec3 ColourOf(Layer layer, const PixelEstimate& pixel) {
  uint32_t words[3] = {};
  EntryOf(layer).develop(pixel, words);
  return {std::bit_cast<float>(words[0]), std::bit_cast<float>(words[1]),
          std::bit_cast<float>(words[2])};
}

float FloatOf(Layer layer, const OnePixel& pixel, size_t channel = 0) {
  uint32_t words[3] = {};
  EntryOf(layer).develop(EstimateOf(pixel), words);
  return std::bit_cast<float>(words[channel]);
}

uint32_t WholeOf(Layer layer, const OnePixel& pixel) {
  uint32_t word = 0;
  EntryOf(layer).develop(EstimateOf(pixel), &word);
  return word;
}

TEST(Layers, HaveNamesOfTheirOwn) {
  std::set<std::string_view> names;
  for (const LayerEntry& entry : Layers()) {
    EXPECT_TRUE(names.insert(entry.name).second) << entry.name;
    EXPECT_FALSE(entry.channels.empty() || entry.description.empty()) << entry.name;
  }
  EXPECT_EQ(EntryOf(Layer::kStandardError).name, "standard_error");
  EXPECT_EQ(EntryOf(Layer::kObjectId).name, "object_id");
}

TEST(PixelLayers, ShowTheSurfaceOfTheSampleNearestToTheMiddle) {
  const int orders[][3] = {{0, 1, 2}, {2, 1, 0}, {1, 2, 0}};
  for (const auto& order : orders) {
    OnePixel pixel;
    for (const int i : order) {
      const float distances[] = {0.3f, 0.1f, 0.1f};
      pixel.Add(Seen(7 + i, 10.0f + static_cast<float>(i)), {}, 1, distances[i],
                static_cast<uint32_t>(i));
    }
    EXPECT_EQ(WholeOf(Layer::kObjectId, pixel), 8u);  // The first of two that are as near.
    EXPECT_EQ(FloatOf(Layer::kDepth, pixel), 11);
    EXPECT_EQ(WholeOf(Layer::kSampleCount, pixel), 3u);
  }
}

TEST(PixelLayers, NothingIsFarAwayAndHasNumberZero) {
  OnePixel pixel;
  pixel.Add({}, {1, 1, 1}, 1, 0, 0);
  EXPECT_EQ(FloatOf(Layer::kDepth, pixel), 1e10f);
  EXPECT_EQ(WholeOf(Layer::kObjectId, pixel), 0u);
  EXPECT_EQ(WholeOf(Layer::kMaterialId, pixel), 0u);
}

TEST(PixelLayers, LightAndAlbedoAreWeightedMeans) {
  OnePixel pixel;
  SampleLayers one, other;
  one.albedo = {1, 0.5f, 0};
  one.AddLight(0, {8, 0, 0});
  one.AddLight(1, {4, 4, 4});
  other.AddLight(2, {1, 2, 3});
  other.AddLight(5, {1, 2, 3});
  pixel.Add(one, {12, 4, 4}, 3, 0, 0);
  pixel.Add(other, {2, 4, 6}, 1, 0, 1);
  EXPECT_EQ(ColourOf(Layer::kAlbedo, EstimateOf(pixel)), (Rgb{0.75f, 0.375f, 0}));
  EXPECT_EQ(ColourOf(Layer::kEmission, EstimateOf(pixel)), (Rgb{6, 0, 0}));
  EXPECT_EQ(ColourOf(Layer::kDirect, EstimateOf(pixel)), (Rgb{3, 3, 3}));
  EXPECT_EQ(ColourOf(Layer::kIndirect, EstimateOf(pixel)), (Rgb{0.5f, 1, 1.5f}));
}

// 1 and 3 have the mean 2 and the variance 2, so that of their mean is 1.
TEST(PixelLayers, StandardErrorIsThatOfTheMean) {
  OnePixel pixel;
  pixel.Add({}, {1, 5, 0}, 1, 0, 0);
  EXPECT_EQ(EstimateOf(pixel).StandardError(), (Rgb{0, 0, 0}));
  pixel.Add({}, {3, 5, 0}, 1, 0, 1);
  EXPECT_EQ(EstimateOf(pixel).StandardError(), (Rgb{1, 0, 0}));
  // Five of each have the variance 10 / 9, and their mean has a tenth of that.
  for (uint32_t i = 2; i < 10; ++i) pixel.Add({}, {i % 2 ? 3.0f : 1.0f, 5, 0}, 1, 0, i);
  EXPECT_FLOAT_EQ(EstimateOf(pixel).StandardError().x, 1.0f / 3);
}

// Each of two series counts as much as the other, whatever their numbers of samples.
TEST(PixelEstimate, IsTheMeanOfItsParts) {
  OnePixel a, b, nothing;
  SampleLayers sample = Seen(5, 1);
  sample.albedo = {1, 0, 0};
  a.Add(sample, {1, 5, 0}, 1, 0.2f, 0);
  a.Add(sample, {3, 5, 0}, 1, 0.3f, 1);
  sample.surface.object = 6;
  sample.albedo = {0, 1, 0};
  for (uint32_t i = 0; i < 4; ++i) b.Add(sample, {4, 5, 0}, 1, 0.1f, i);
  const PixelPart parts[] = {a.Part(), b.Part(), nothing.Part()};
  const PixelEstimate both({parts, 2});
  EXPECT_EQ(both.Colour(), (Rgb{3, 5, 0}));
  EXPECT_EQ(both.StandardError(), (Rgb{0.5f, 0, 0}));  // Of 1 and 0.
  EXPECT_EQ(both.SampleCount(), 6u);
  EXPECT_EQ(both.Nearest().Surface().object, 6u);
  EXPECT_EQ(ColourOf(Layer::kAlbedo, both), (Vec3{0.5f, 0.5f, 0}));
  // One of which no sample counts says nothing.
  EXPECT_EQ(PixelEstimate({parts + 1, 2}).Colour(), (Rgb{4, 5, 0}));
  EXPECT_EQ(PixelEstimate({parts + 2, 1}).Colour(), (Rgb{0, 0, 0}));
}

TEST(Film, KeepsTheLayersThatAreAskedFor) {
  const PixelWindow window{2, 3, 5, 5};
  Film film(window, Film::Keep::kColours, Film::Negative::kTake,
            LayerSet{Layer::kObjectId, Layer::kUv});
  FilmTile tile;
  film.BeginTile(window, &tile);
  SampleLayers sample = Seen(42, 1);
  sample.surface.uv = {0.25f, 0.75f};
  ASSERT_TRUE(tile.Add(4, 3, {1, 1, 1}, 1));
  tile.LayersAt(4, 3).SetSurface(sample.surface);
  tile.AddLayers(4, 3, sample, 1);
  film.EndTile(tile);
  EXPECT_THAT(film.LayerWords(Layer::kObjectId), testing::ElementsAre(0, 0, 42, 0, 0, 0));
  const auto uv = film.LayerWords(Layer::kUv);
  ASSERT_EQ(uv.size(), 12u);
  EXPECT_EQ(std::bit_cast<float>(uv[4]), 0.25f);
  EXPECT_EQ(std::bit_cast<float>(uv[5]), 0.75f);
}

/// The values of a layer of a film of one pixel.
std::vector<float> ValuesOf(const Film& film, Layer layer) {
  std::vector<float> values;
  for (const uint32_t word : film.LayerWords(layer)) values.push_back(std::bit_cast<float>(word));
  return values;
}

const std::array<std::string, 2> kGroups = {"sky", "lamps"};

// Sums of weighted samples in both ways that a film keeps them.
TEST(Film, DevelopsTheLightOfEachGroup) {
  const PixelWindow window{0, 0, 1, 1};
  for (const Film::Keep keep : {Film::Keep::kColours, Film::Keep::kSums}) {
    Film film(window, keep, Film::Negative::kTake, LayerSet{Layer::kLightGroups}, kGroups);
    EXPECT_THAT(film.NamesOf(Layer::kLightGroups),
                testing::ElementsAre("light_group_sky", "light_group_lamps"));
    FilmTile tile;
    film.BeginTile(window, &tile);
    const Rgb first[] = {{8, 0, 4}, {0, 4, 0}}, second[] = {{0, 0, 0}, {4, 0, 8}};
    ASSERT_TRUE(tile.Add(0, 0, {8, 4, 4}, 3));
    tile.AddLightGroups(0, 0, first, 3);
    if (keep == Film::Keep::kSums) {  // Goes on in a second pass.
      film.EndTile(tile);
      film.BeginTile(window, &tile);
    }
    ASSERT_TRUE(tile.Add(0, 0, {4, 0, 8}, 1));
    tile.AddLightGroups(0, 0, second, 1);
    film.EndTile(tile);
    EXPECT_THAT(ValuesOf(film, Layer::kLightGroups), testing::ElementsAre(6, 0, 3, 1, 3, 2));
  }
}

TEST(Film, DevelopsTheMeanOfTheGroupsOfTwoSeries) {
  const PixelWindow window{0, 0, 1, 1};
  Film film(window, Film::Keep::kColours, Film::Negative::kTake, LayerSet{Layer::kLightGroups},
            kGroups);
  FilmTile a, b;
  film.BeginSeries(window, &a);
  film.BeginSeries(window, &b);
  const Rgb of_a[] = {{1, 0, 0}, {0, 2, 0}}, of_b[] = {{3, 0, 0}, {0, 0, 6}};
  ASSERT_TRUE(a.Add(0, 0, {1, 2, 0}, 1));
  a.AddLightGroups(0, 0, of_a, 1);
  for (int i = 0; i < 2; ++i) {
    ASSERT_TRUE(b.Add(0, 0, {3, 0, 6}, 1));
    b.AddLightGroups(0, 0, of_b, 1);
  }
  film.EndSeries(a, b);
  EXPECT_EQ(film.Pixel(0, 0), (Rgb{2, 1, 3}));
  EXPECT_THAT(ValuesOf(film, Layer::kLightGroups), testing::ElementsAre(2, 0, 0, 0, 1, 3));
}

TEST(Film, DropsNegativeLightWhereItIsAMistake) {
  FilmTile tile;
  for (const auto negative : {Film::Negative::kTake, Film::Negative::kDrop}) {
    Film film({0, 0, 1, 1}, Film::Keep::kColours, negative);
    film.BeginTile({0, 0, 1, 1}, &tile);
    const bool is_taken = negative == Film::Negative::kTake;
    EXPECT_EQ(tile.Add(0, 0, {1, -0.5f, 1}, 1), is_taken);
    // The weight of the filter comes after the judgement.
    EXPECT_TRUE(tile.Add(0, 0, {1, 0.5f, 1}, -1));
    film.EndTile(tile);
  }
}

}  // namespace
}  // namespace candela
