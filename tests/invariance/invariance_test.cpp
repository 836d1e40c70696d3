// A picture does not depend on where in the world its scene stands, nor on how it is described.
// The slow set has more samples.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <ostream>
#include <string>

#include "integrators/path.h"
#include "integrators/registry.h"
#include "tests/invariance/changed_scene.h"
#include "tests/sampling/chi_square.h"
#include "tests/support/compile_text.h"
#include "tests/support/effort.h"
#include "tests/support/render_scene.h"
#include "tests/support/temp_folder.h"

namespace candela::invariance {

void PrintTo(const SceneRow& row, std::ostream* out) {
  *out << row.name;
}

namespace {

using testing_support::kIsSanitized;
using testing_support::kIsSlow;

constexpr int kSize = 24, kBlock = 8;
constexpr uint32_t kSamples = kIsSlow ? 4096 : kIsSanitized ? 8 : 64;
constexpr double kStrength = kIsSlow ? 2e-3 : kIsSanitized ? 0.2 : 0.02;

/// The difference of two pictures over a window, in standard errors. The pixels are independent of
/// each other, and those of the same place have the same mean if nothing depends on the change; so
/// the squares of the differences say how noisy their sum is, whether or not the pictures share
/// their random numbers.
struct Difference {
  double sum = 0, squares = 0, brightness = 0;

  void Add(double a, double b) {
    sum += a - b;
    squares += (a - b) * (a - b);
    brightness += a;
  }
  double Deviate() const { return squares > 0 ? sum / std::sqrt(squares) : 0; }
};

class Picture : public testing::TestWithParam<SceneRow> {
 protected:
  static void SetUpTestSuite() {
    folder_ = std::make_unique<testing_support::TempFolder>();
    PutFiles(folder_->path());
  }
  static void TearDownTestSuite() { folder_.reset(); }

  /// As `path` sees the changed scene. The two pictures of a comparison have different seeds, so
  /// that nothing which they share is taken for agreement.
  static Image Render(Change change, uint32_t seed, uint32_t samples) {
    const auto scene =
        testing_support::CompileText(ChangedScene(GetParam(), change), folder_->path());
    IntegratorOptions path;
    path.bounces = 5;
    path.seed = seed;
    RenderOptions options = testing_support::WholePicture(kSize, kSize);
    options.grid = PixelGrid::kCentres;
    options.pattern = SamplePattern::kFilter;
    options.samples = samples;
    options.seed = seed;
    return testing_support::RenderImage(PathIntegrator(*scene, path), options);
  }

  static std::unique_ptr<testing_support::TempFolder> folder_;
};

std::unique_ptr<testing_support::TempFolder> Picture::folder_;

INSTANTIATE_TEST_SUITE_P(Scenes, Picture, testing::ValuesIn(Scenes()),
                         [](const auto& row) { return std::string(row.param.name); });

double Grey(const Image& image, int x, int y) {
  double sum = 0;
  for (const float value : image.Pixel(x, y)) sum += static_cast<double>(value);
  return sum / 3;
}

// P17: in blocks of 8 x 8 pixels, and in the whole picture.
TEST_P(Picture, StaysTheSameUnderChangesThatDoNotMatter) {
  const Image plain = Render(Change::kNone, 1, kSamples);
  for (const auto& [name, change] : kChanges) {
    SCOPED_TRACE(name);
    const Image changed = Render(change, 2, kSamples);
    Difference whole;
    for (int y0 = 0; y0 < kSize; y0 += kBlock) {
      for (int x0 = 0; x0 < kSize; x0 += kBlock) {
        Difference block;
        for (int y = y0; y < y0 + kBlock; ++y) {
          for (int x = x0; x < x0 + kBlock; ++x) {
            const int there = change == Change::kMirror ? kSize - 1 - x : x;
            block.Add(Grey(plain, x, y), Grey(changed, there, y));
            whole.Add(Grey(plain, x, y), Grey(changed, there, y));
          }
        }
        EXPECT_LE(std::abs(block.Deviate()), test::kLargestDeviate) << x0 << ", " << y0;
      }
    }
    EXPECT_LE(std::abs(whole.Deviate()), test::kLargestDeviate);
    EXPECT_GT(whole.brightness, 0);
    EXPECT_LE(std::sqrt(whole.squares), kStrength * whole.brightness) << "too noisy to tell";
  }
}

// P17: the search for hits does not know in which order objects came, unless they are hit at the
// same distance.
TEST_P(Picture, HasTheSameBitsForAnyOrderOfItsObjects) {
  EXPECT_EQ(Render(Change::kReorder, 3, 8), Render(Change::kNone, 3, 8));
}

}  // namespace
}  // namespace candela::invariance
