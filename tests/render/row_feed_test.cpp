// Rows reach the encoder in order, whatever the order in which tiles are finished.

#include "render/row_feed.h"

#include <gtest/gtest.h>

#include <numeric>
#include <random>

#include "base/parallel.h"

namespace candela {
namespace {

constexpr PixelWindow kWindow{5, 9, 5 + 70, 9 + 50};

/// A film whose pixels all differ.
Film MakeFilm() {
  return Film(kWindow, Film::Keep::kColours);
}

void Fill(const PixelWindow& window, Film* film) {
  for (int y = window.y0; y < window.y1; ++y) {
    for (int x = window.x0; x < window.x1; ++x) {
      film->SetOnlySample(x, y, {static_cast<float>(x) / 80, static_cast<float>(y) / 60, 0.25f});
    }
  }
}

std::string Expected() {
  Film film = MakeFilm();
  Fill(kWindow, &film);
  return EncodeImage(ToImage(film), ImageFormat::kPng, EncodeOptions()).value();
}

TEST(RowFeed, AnyOrderOfTilesGivesTheFile) {
  const Tiles tiles(kWindow, 16);
  std::vector<int64_t> order(static_cast<size_t>(tiles.Count()));
  std::iota(order.begin(), order.end(), 0);
  std::mt19937 random(1);
  for (int i = 0; i < 20; ++i) {
    std::shuffle(order.begin(), order.end(), random);
    Film film = MakeFilm();
    FilmEncoder encoder(film, ImageFormat::kPng, EncodeOptions());
    RowFeed feed(tiles, &encoder);
    for (const int64_t tile : order) {
      Fill(tiles.Window(tile), &film);
      feed.TileDone(tile);
    }
    EXPECT_TRUE(encoder.Finish().value() == Expected());
  }
}

TEST(RowFeed, TilesOfSeveralThreadsGiveTheFile) {
  const ThreadLimit threads(7);
  const Tiles tiles(kWindow, 4);
  for (int i = 0; i < 20; ++i) {
    Film film = MakeFilm();
    FilmEncoder encoder(film, ImageFormat::kPng, EncodeOptions());
    RowFeed feed(tiles, &encoder);
    ParallelFor(tiles.Count(), [&](int64_t tile) {
      Fill(tiles.Window(tile), &film);
      feed.TileDone(tile);
    });
    EXPECT_TRUE(encoder.Finish().value() == Expected());
  }
}

}  // namespace
}  // namespace candela
