#include "film/film.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>
#include <thread>

#include "tests/sampling/chi_square.h"

namespace candela {
namespace {

constexpr float kInf = std::numeric_limits<float>::infinity();
constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

struct TestSample {
  int x, y;
  Rgb radiance;
  float weight;
};

/// `per_pixel` samples of each pixel: bright and dark ones, some of negative weight.
std::vector<TestSample> MakeSamples(const PixelWindow& window, int per_pixel) {
  test::UniformNumbers numbers(6);
  std::vector<TestSample> samples;
  for (int i = 0; i < per_pixel; ++i) {
    for (int y = window.y0; y < window.y1; ++y) {
      for (int x = window.x0; x < window.x1; ++x) {
        const float scale = numbers.Next() < 0.01f ? 1e6f : 1.0f;
        const float red = numbers.Next(), green = numbers.Next(), blue = numbers.Next();
        const float weight = numbers.Next() < 0.1f ? -1.2f : 1.2f;
        samples.push_back({x, y, Rgb{red, green, blue} * scale, weight});
      }
    }
  }
  return samples;
}

/// Adds the samples that lie in the window as one tile.
void AddTile(const std::vector<TestSample>& samples, const PixelWindow& window, Film* film) {
  FilmTile tile;
  film->BeginTile(window, &tile);
  for (const TestSample& s : samples) {
    if (s.x >= window.x0 && s.x < window.x1 && s.y >= window.y0 && s.y < window.y1) {
      tile.Add(s.x, s.y, s.radiance, s.weight);
    }
  }
  film->EndTile(tile);
}

std::vector<float> Bytes(const Film& film) {
  std::vector<float> all;
  for (int y = film.Window().y0; y < film.Window().y1; ++y) {
    const auto row = film.Row(y);
    all.insert(all.end(), row.begin(), row.end());
  }
  return all;
}

constexpr PixelWindow kWindow{3, 2, 12, 9};

std::vector<float> RenderedAtOnce(const std::vector<TestSample>& samples) {
  Film film(kWindow, Film::Keep::kColours);
  AddTile(samples, kWindow, &film);
  return Bytes(film);
}

TEST(Film, OrderOfSamplesDoesNotMatter) {
  std::vector<TestSample> samples = MakeSamples(kWindow, 50);
  const std::vector<float> expected = RenderedAtOnce(samples);
  std::shuffle(samples.begin(), samples.end(), std::mt19937(9));
  EXPECT_EQ(RenderedAtOnce(samples), expected);
}

TEST(Film, TilesAndThreadsDoNotMatter) {
  const std::vector<TestSample> samples = MakeSamples(kWindow, 50);
  const std::vector<float> expected = RenderedAtOnce(samples);
  for (const int side : {1, 2, 5}) {
    Film film(kWindow, Film::Keep::kColours);
    std::vector<std::thread> threads;
    for (int y = kWindow.y0; y < kWindow.y1; y += side) {
      threads.emplace_back([&film, &samples, y, side] {
        for (int x = kWindow.x0; x < kWindow.x1; x += side) {
          AddTile(samples, {x, y, std::min(x + side, kWindow.x1), std::min(y + side, kWindow.y1)},
                  &film);
        }
      });
    }
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(Bytes(film), expected) << side;
  }
}

TEST(Film, AHundredSamplesAndFourHundredMoreAreFiveHundred) {
  const std::vector<TestSample> samples = MakeSamples(kWindow, 500);
  const auto first_pass = static_cast<std::ptrdiff_t>(samples.size() / 5);
  Film film(kWindow, Film::Keep::kSums);
  AddTile({samples.begin(), samples.begin() + first_pass}, kWindow, &film);
  // The second pass cuts the picture differently.
  const std::vector<TestSample> rest(samples.begin() + first_pass, samples.end());
  AddTile(rest, {3, 2, 7, 9}, &film);
  AddTile(rest, {7, 2, 12, 9}, &film);
  EXPECT_EQ(Bytes(film), RenderedAtOnce(samples));
}

TEST(Film, ACropEqualsThatPartOfTheWhole) {
  const std::vector<TestSample> samples = MakeSamples(kWindow, 20);
  Film whole(kWindow, Film::Keep::kColours);
  AddTile(samples, kWindow, &whole);
  const PixelWindow window{5, 3, 8, 8};
  Film crop(window, Film::Keep::kColours);
  AddTile(samples, window, &crop);
  for (int y = 3; y < 8; ++y) {
    for (int x = 5; x < 8; ++x) EXPECT_EQ(crop.Pixel(x, y), whole.Pixel(x, y));
  }
}

TEST(Film, OneSampleOfWeightOneComesBackUnchanged) {
  Film film({0, 0, 1, 1}, Film::Keep::kColours);
  FilmTile tile;
  for (const Rgb colour : {Rgb{0.1f, 0.7f, 1}, Rgb{0, 1e-6f, 12345.678f}, Rgb{1e9f, 3e-5f, 2}}) {
    film.BeginTile({0, 0, 1, 1}, &tile);
    tile.Add(0, 0, colour, 1);
    film.EndTile(tile);
    EXPECT_EQ(film.Pixel(0, 0), colour);
  }
}

TEST(Film, PixelsAreWeightedMeans) {
  Film film({0, 0, 2, 1}, Film::Keep::kColours);
  FilmTile tile;
  film.BeginTile({0, 0, 2, 1}, &tile);
  tile.Add(0, 0, {1, 2, 3}, 1);
  tile.Add(0, 0, {5, 6, 7}, 3);
  tile.Add(1, 0, {8, 8, 8}, 1.5f);
  tile.Add(1, 0, {2, 0, 4}, -0.5f);
  film.EndTile(tile);
  EXPECT_EQ(film.Pixel(0, 0), (Rgb{4, 5, 6}));
  EXPECT_EQ(film.Pixel(1, 0), (Rgb{11, 12, 10}));
}

// Dropped before the weight: the other samples of the pixel keep their mean.
TEST(Film, BrokenSamplesAreDroppedWithTheirWeight) {
  Film film({0, 0, 1, 1}, Film::Keep::kColours);
  FilmTile tile;
  film.BeginTile({0, 0, 1, 1}, &tile);
  tile.Add(0, 0, {1, 2, 3}, 1);
  for (const float broken : {kNaN, kInf, -kInf, -kNaN}) {
    EXPECT_FALSE(tile.Add(0, 0, {broken, 1, 1}, 1));
    EXPECT_FALSE(tile.Add(0, 0, {1, broken, 1}, -1));
    EXPECT_FALSE(tile.Add(0, 0, {1, 1, broken}, 1));
  }
  EXPECT_TRUE(tile.Add(0, 0, {3, 2, 1}, 1));
  film.EndTile(tile);
  EXPECT_EQ(film.Pixel(0, 0), (Rgb{2, 2, 2}));
}

TEST(Film, PixelsWithoutSamplesAreBlack) {
  Film film(kWindow, Film::Keep::kSums);
  FilmTile tile;
  film.BeginTile({3, 2, 4, 3}, &tile);
  tile.Add(3, 2, {kNaN, 1, 1}, 1);
  film.EndTile(tile);
  for (const float value : Bytes(film)) EXPECT_EQ(value, 0);
}

// A light of negative colour takes away in one channel and leaves the others alone.
TEST(Film, NegativeChannelsStayAsTheyAre) {
  const PixelWindow window{0, 0, 2, 1};
  Film film(window, Film::Keep::kColours);
  FilmTile tile;
  film.BeginTile(window, &tile);
  EXPECT_TRUE(tile.Add(0, 0, {-0.5f, 2, 0}, 1));
  film.EndTile(tile);
  EXPECT_TRUE(film.SetOnlySample(1, 0, {-0.5f, 2, 0}));
  EXPECT_EQ(film.Pixel(0, 0), (Rgb{-0.5f, 2, 0}));
  EXPECT_EQ(film.Pixel(1, 0), (Rgb{-0.5f, 2, 0}));
}

}  // namespace
}  // namespace candela
