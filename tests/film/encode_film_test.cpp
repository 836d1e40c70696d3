#include "film/encode_film.h"

#include <gtest/gtest.h>

#include <utility>

namespace candela {
namespace {

/// A crop window whose pixels have values of their own, some beyond what bytes can hold.
struct TestFilm {
  TestFilm() {
    FilmTile tile;
    film.BeginTile(kWindow, &tile);
    for (int y = kWindow.y0; y < kWindow.y1; ++y) {
      for (int x = kWindow.x0; x < kWindow.x1; ++x) {
        const auto s = static_cast<float>(x), t = static_cast<float>(y);
        tile.Add(x, y, {s / 17, t / 13, s * t / 100}, 1);
      }
    }
    film.EndTile(tile);
  }

  static constexpr PixelWindow kWindow{3, 5, 20, 16};
  Film film{kWindow, Film::Keep::kColours};
};

TEST(ToImage, HoldsThePixelsOfTheWindow) {
  const TestFilm test;
  const Film& film = test.film;
  const Image image = ToImage(film);
  ASSERT_EQ(image.Width(), 17);
  ASSERT_EQ(image.Height(), 11);
  for (const auto& [x, y] : {std::pair(0, 0), std::pair(16, 10), std::pair(4, 7)}) {
    const Rgb pixel = film.Pixel(3 + x, 5 + y);
    EXPECT_EQ(image.At(x, y, 0), pixel.x);
    EXPECT_EQ(image.At(x, y, 1), pixel.y);
    EXPECT_EQ(image.At(x, y, 2), pixel.z);
  }
}

TEST(FilmEncoder, GivesTheBytesOfItsImageInEveryFormat) {
  const TestFilm test;
  const Film& film = test.film;
  for (const ImageFormat format : {ImageFormat::kPng, ImageFormat::kJpeg, ImageFormat::kExr,
                                   ImageFormat::kHdr, ImageFormat::kPfm}) {
    for (const int bits : {8, 16, -8}) {
      EncodeOptions options;
      options.png_bits = std::abs(bits);
      if (bits < 0) options.tone = {FindToneCurve("filmic"), 2};
      FilmEncoder encoder(film, format, options);
      for (const int y_end : {0, 3, 3, 10}) encoder.Advance(y_end);
      const auto direct = encoder.Finish();
      const auto by_image = EncodeImage(ToImage(film), format, options);
      ASSERT_TRUE(direct && by_image);
      EXPECT_TRUE(*direct == *by_image) << static_cast<int>(format) << ", " << bits << " bits";
    }
  }
}

TEST(FilmEncoder, EncodesWhatFinishingLeaves) {
  const TestFilm test;
  const auto finish = [](Image* picture) {
    for (float& value : picture->Samples()) value = 1 - value / 2;
  };
  Image finished = ToImage(test.film);
  finish(&finished);
  for (const ImageFormat format : {ImageFormat::kPng, ImageFormat::kJpeg, ImageFormat::kExr,
                                   ImageFormat::kHdr, ImageFormat::kPfm}) {
    FilmEncoder encoder(test.film, format, {}, finish);
    encoder.Advance(3);
    const auto direct = encoder.Finish();
    const auto by_image = EncodeImage(finished, format);
    ASSERT_TRUE(direct && by_image);
    EXPECT_TRUE(*direct == *by_image) << static_cast<int>(format);
  }
}

}  // namespace
}  // namespace candela
