// How film and filters show edges, fine patterns, dots and even light, for each filter of the
// table.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <string>
#include <vector>

#include "film/pixel_filter.h"
#include "math/elementary.h"
#include "tests/optics/bright_scene.h"
#include "tests/support/image_function.h"

namespace candela {
namespace {

class EveryFilter : public testing::TestWithParam<PixelFilterEntry> {
 protected:
  std::string Name() const { return std::string(GetParam().name); }

  /// What is left of a wave of so many cycles per pixel, by the profile of the filter.
  double Transfer(double frequency) const {
    constexpr int kSteps = 20000;
    const double radius = static_cast<double>(GetParam().radius);
    double wave = 0, whole = 0;
    for (int i = 0; i < kSteps; ++i) {
      const double x = radius * (i + 0.5) / kSteps;
      const double height = GetParam().profile(x);
      wave += height * std::cos(2 * kPi * frequency * x);
      whole += height;
    }
    return wave / whole;
  }
};

INSTANTIATE_TEST_SUITE_P(Table, EveryFilter,
                         testing::ValuesIn(PixelFilters().begin(), PixelFilters().end()),
                         [](const auto& row) { return std::string(row.param.name); });

/// The contrast with which a picture shows waves of `frequency` cycles per pixel that cross an edge
/// through its middle; the edge leans by `degrees` to the left, and its left side is bright. After
/// ISO 12233: the pixels of all rows together are one finely sampled profile of the edge.
double TransferOfEdge(const Image& image, double degrees, double frequency) {
  constexpr double kBin = 0.125;
  constexpr int kBins = 160;
  std::vector<double> sums(kBins), counts(kBins);
  for (int y = 0; y < image.Height(); ++y) {
    for (int x = 0; x < image.Width(); ++x) {
      const double right = x + 0.5 - image.Width() / 2.0, up = image.Height() / 2.0 - y - 0.5;
      const double beyond = right * CosDegrees(degrees) + up * SinDegrees(degrees);
      const double bin = std::floor(beyond / kBin) + kBins / 2.0;
      if (bin < 0 || bin >= kBins) continue;
      sums[static_cast<size_t>(bin)] += static_cast<double>(image.At(x, y));
      ++counts[static_cast<size_t>(bin)];
    }
  }
  std::complex<double> wave = 0;
  double whole = 0;
  for (size_t i = 0; i + 1 < kBins; ++i) {
    EXPECT_GT(counts[i], 0);
    const double step = sums[i] / counts[i] - sums[i + 1] / counts[i + 1];
    wave += step * std::polar(1.0, -2 * kPi * frequency * kBin * static_cast<double>(i));
    whole += step;
  }
  // Bins are means over their width, and the steps between them are differences over it.
  const double x = kPi * frequency * kBin;
  const double blur = std::sin(x) / x;
  return std::abs(wave) / whole / (blur * blur);
}

// P15, CF26: box sinc f, tent sinc^2 f, Gauss exp(-2 pi^2 s^2 f^2), and the others by their
// profiles. Across an edge that leans, the filter acts along both of its axes.
TEST_P(EveryFilter, ShowsASlantedEdgeWithTheTransferOfItsProfile) {
  constexpr double kLean = 5;
  const auto scene = test::SceneOf(
      test::Shining(fmt::format("translate 0 0 -10 z_rotate {} translate -20 0 0", kLean),
                    "rectangle width 40 height 80"));
  const Image image = test::Seen(*scene, test::Picture(64, 192, Name(), 256));
  for (const double frequency : {0.1, 0.25, 0.4}) {
    const double expected =
        Transfer(frequency * CosDegrees(kLean)) * Transfer(frequency * SinDegrees(kLean));
    EXPECT_NEAR(TransferOfEdge(image, kLean, frequency), expected, 0.02 * expected) << frequency;
  }
}

// CF26
TEST(SlantedEdge, AtAQuarterCycleHasTheContrastOfTheClosedForms) {
  const struct {
    const char* filter;
    double transfer;
  } cases[] = {{"box", 0.900316}, {"tent", 0.810569}, {"gaussian", 0.734603}};
  const auto scene = test::SceneOf(test::Shining("translate 0 0 -10 z_rotate 5 translate -20 0 0",
                                                 "rectangle width 40 height 80"));
  for (const auto& [filter, transfer] : cases) {
    const Image image = test::Seen(*scene, test::Picture(64, 192, filter, 256));
    EXPECT_NEAR(TransferOfEdge(image, 5, 0.25), transfer, 0.02 * transfer) << filter;
  }
}

/// The largest contrast of rings that have from 1 to 3 cycles per pixel, which no picture can show:
/// what is seen of them is an alias.
struct Rings {
  double coarse = 0;  ///< The swing in the middle, where there is less than a tenth of a cycle.
  double alias = 0;
};

Rings ContrastOfZonePlate(const RenderOptions& options) {
  constexpr double kWidth = 128, kChirp = 3 / (kWidth / 2);  // Cycles per pixel, in each pixel.
  const testing_support::ImageFunction plate([](Vec2 p) {
    const double x = static_cast<double>(p.x) * kWidth / 2;
    const double y = static_cast<double>(p.y) * kWidth / 2;
    return static_cast<float>(0.5 + 0.5 * std::cos(kPi * kChirp * (x * x + y * y)));
  });
  const Image image = testing_support::RenderImage(plate, options);
  // Rings of nearly the same frequency, near the axis x, where the filters are weakest.
  std::vector<double> squares(30), counts(30);
  for (int y = 0; y < image.Height(); ++y) {
    for (int x = 0; x < image.Width(); ++x) {
      const double right = x + 0.5 - kWidth / 2, up = kWidth / 2 - y - 0.5;
      if (std::abs(up) > 0.2 * std::abs(right)) continue;
      const auto ring = static_cast<size_t>(kChirp * std::sqrt(right * right + up * up) * 10);
      if (ring >= squares.size()) continue;
      const double swing = (static_cast<double>(image.At(x, y)) - 0.5) / 0.5;
      squares[ring] += swing * swing;
      ++counts[ring];
    }
  }
  // A wave of amplitude A has the mean square A^2 / 2.
  const auto contrast = [&](size_t ring) { return std::sqrt(2 * squares[ring] / counts[ring]); };
  const auto middle = static_cast<double>(image.At(image.Width() / 2, image.Height() / 2));
  Rings rings{(middle - 0.5) / 0.5, 0};
  for (size_t ring = 10; ring < 30; ++ring) rings.alias = std::max(rings.alias, contrast(ring));
  return rings;
}

// P15: at 1 to 3 cycles per pixel a box leaves at most sinc = 0.217, a soft filter next to nothing.
TEST_P(EveryFilter, HidesRingsThatAreFinerThanPixels) {
  const Rings rings = ContrastOfZonePlate(test::Picture(128, 128, Name(), 256));
  EXPECT_GT(rings.coarse, 0.85) << "the rings that can be seen";
  EXPECT_LT(rings.alias, Name() == "box" ? 0.22 : 0.05);
}

// The test above sees aliases where there are some: with one sample in the middle of each pixel.
TEST(ZonePlate, WithoutAFilterHasFalseRings) {
  RenderOptions options = test::Picture(128, 128, "box", 1);
  options.pattern = SamplePattern::kCentre;
  EXPECT_GT(ContrastOfZonePlate(options).alias, 0.9);
}

// P15: weights sum to 1, those of filters with negative sides included.
TEST_P(EveryFilter, LeavesEvenLightAsItIs) {
  const testing_support::ImageFunction even([](Vec2) { return 0.7f; });
  const Image image = testing_support::RenderImage(even, test::Picture(16, 16, Name(), 64));
  for (const float value : image.Samples()) EXPECT_NEAR(value, 0.7f, 1e-7f);
}

// P15: the mean of all pixels is that of the light, so nothing is lost at the edges of pixels.
TEST_P(EveryFilter, KeepsTheLightOfADot) {
  const auto scene = test::SceneOf(test::Shining("translate 0.31 -0.17 -10", "disk radius 1"));
  const Image image = test::Seen(*scene, test::Picture(24, 24, Name(), 2048));
  double sum = 0;
  for (int y = 0; y < 24; ++y) {
    for (int x = 0; x < 24; ++x) sum += static_cast<double>(image.At(x, y));
  }
  const double pixels = kPi * (24 / 20.0) * (24 / 20.0);
  EXPECT_NEAR(sum, pixels, 2e-3 * pixels);
}

// P15: the picture is not shifted: the centroid of a dot is where the dot is, to a hundredth of a
// pixel. Filters with edges round the place of a small dot to the pixels, one way here and the
// other way there; so it is the mean over places within a pixel.
TEST_P(EveryFilter, ShowsADotInItsPlace) {
  constexpr int kPlaces = 5, kWidth = 25;
  for (const PixelGrid grid : {PixelGrid::kCentres, PixelGrid::kCorners}) {
    // With pixel centres on the edges a picture of 25 pixels is 24 wide, and begins with the middle
    // of the first one.
    const double pixels = grid == PixelGrid::kCentres ? kWidth : kWidth - 1;
    const double first = grid == PixelGrid::kCentres ? 0.5 : 0;
    RenderOptions options = test::Picture(kWidth, kWidth, Name(), 1024);
    options.grid = grid;
    double shift_x = 0, shift_y = 0;
    for (int place = 0; place < kPlaces; ++place) {
      const double x = 0.031 + 2 / pixels * place / kPlaces,
                   y = -0.017 + 2 / pixels * place / kPlaces;
      const auto scene = test::SceneOf(test::Shining(
          fmt::format("translate {:.9g} {:.9g} -10", 10 * x, 10 * y), "disk radius 1"));
      const Image image = test::Seen(*scene, options);
      double sum = 0, sum_x = 0, sum_y = 0;
      for (int row = 0; row < kWidth; ++row) {
        for (int column = 0; column < kWidth; ++column) {
          const double value = static_cast<double>(image.At(column, row));
          sum += value;
          sum_x += value * column;
          sum_y += value * row;
        }
      }
      shift_x += (sum_x / sum - ((1 + x) / 2 * pixels - first)) / kPlaces;
      shift_y += (sum_y / sum - ((1 - y) / 2 * pixels - first)) / kPlaces;
    }
    EXPECT_NEAR(shift_x, 0, 0.01);
    EXPECT_NEAR(shift_y, 0, 0.01);
  }
}

}  // namespace
}  // namespace candela
