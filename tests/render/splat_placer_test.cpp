#include "render/splat_placer.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

namespace candela {
namespace {

RenderOptions Picture(SamplePattern pattern, const std::string& filter = "box") {
  RenderOptions options;
  options.width = 16;
  options.height = 12;
  options.crop = {0, 0, 16, 12};
  options.grid = PixelGrid::kCentres;
  options.pattern = pattern;
  options.filter = filter;
  return options;
}

/// The red that pixel (x, y) has got.
double Red(const SplatFilm& film, int x, int y) {
  return static_cast<double>(film.Mean(x, y, 1).x);
}

double Sum(const SplatFilm& film) {
  double sum = 0;
  for (int y = film.Window().y0; y < film.Window().y1; ++y) {
    for (int x = film.Window().x0; x < film.Window().x1; ++x) sum += Red(film, x, y);
  }
  return sum;
}

/// One unit of light, whatever the size of the image plane, at a position in the picture.
Splat UnitAt(const ImagePlane& plane, int x, int y, Vec2 offset) {
  return {plane.PointOf(x, y, offset), Spectrum(1 / plane.PixelsPerArea())};
}

TEST(SplatPlacer, GivesASplatToThePixelThatItFallsIn) {
  const RenderOptions options = Picture(SamplePattern::kCentre);
  const ImagePlane plane(options.width, options.height, options.grid, options.stretch);
  const SplatPlacer placer(options);
  for (const Vec2 offset : {Vec2{0, 0}, Vec2{0.49f, -0.49f}, Vec2{-0.49f, 0.25f}}) {
    SplatFilm film(options.crop);
    placer.Add(UnitAt(plane, 5, 7, offset), &film);
    EXPECT_NEAR(Red(film, 5, 7), 1, 1e-6);
    EXPECT_NEAR(Sum(film), 1, 1e-6);
  }
}

TEST(SplatPlacer, LeavesOutWhatFallsBeside) {
  RenderOptions options = Picture(SamplePattern::kFilter, "mitchell");
  const SplatPlacer placer(options);
  options.crop = {3, 3, 9, 9};
  SplatFilm film(options.crop);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  for (const Vec2 point :
       {Vec2{1e30f, 0}, Vec2{-5, 5}, Vec2{0, 0.99f}, Vec2{nan, 0}, Vec2{0, nan}}) {
    placer.Add({point, Spectrum(1)}, &film);
  }
  EXPECT_EQ(Sum(film), 0);
  EXPECT_EQ(film.DroppedSplats(), 0u);
}

TEST(SplatPlacer, DropsNegativeLightWhereItIsAMistake) {
  RenderOptions options = Picture(SamplePattern::kFilter, "mitchell");
  const ImagePlane plane(options.width, options.height, options.grid, options.stretch);
  Splat negative = UnitAt(plane, 5, 7, {0, 0});
  negative.radiance *= Spectrum(-1);
  for (const bool drops : {false, true}) {
    options.drops_negative = drops;
    SplatFilm film(options.crop);
    const SplatPlacer placer(options);
    placer.Add(negative, &film);
    EXPECT_NEAR(Sum(film), drops ? 0 : -1, 1e-4);
    EXPECT_EQ(film.DroppedSplats(), drops ? 1u : 0u);
    // The weights of the filter are no mistake.
    placer.Add(UnitAt(plane, 5, 7, {0.4f, 0}), &film);
    EXPECT_EQ(film.DroppedSplats(), drops ? 1u : 0u);
  }
}

// Where splats cover the image plane evenly every pixel gets the same, whatever the filter: the
// integral of each is 1, and no splat is lost between pixels.
TEST(SplatPlacer, OfAnEvenLightMakesAnEvenPicture) {
  std::vector<RenderOptions> all = {Picture(SamplePattern::kStrata),
                                    Picture(SamplePattern::kStrataTent)};
  for (const PixelFilterEntry& filter : PixelFilters()) {
    all.push_back(Picture(SamplePattern::kFilter, std::string(filter.name)));
  }
  for (const RenderOptions& options : all) {
    SCOPED_TRACE(options.filter);
    const ImagePlane plane(options.width, options.height, options.grid, options.stretch);
    const SplatPlacer placer(options);
    SplatFilm film({4, 4, 7, 7});
    constexpr int kPerSide = 20;
    for (int y = 0; y < 11 * kPerSide; ++y) {
      for (int x = 0; x < 11 * kPerSide; ++x) {
        const Vec2 offset{(static_cast<float>(x) + 0.5f) / kPerSide - 0.5f,
                          (static_cast<float>(y) + 0.5f) / kPerSide - 0.5f};
        placer.Add(UnitAt(plane, 0, 0, offset), &film);
      }
    }
    for (int y = 4; y < 7; ++y) {
      for (int x = 4; x < 7; ++x) {
        EXPECT_NEAR(film.Mean(x, y, kPerSide * kPerSide).x, 1, 2e-3) << x << ' ' << y;
      }
    }
  }
}

}  // namespace
}  // namespace candela
