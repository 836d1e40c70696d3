// Textures from far away: a ray stands for a wide part of them.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "image/image_file.h"
#include "integrators/path.h"
#include "integrators/registry.h"
#include "tests/support/compile_text.h"
#include "tests/support/temp_folder.h"

namespace candela {
namespace {

using testing_support::CompileText;

class Footprint : public testing::Test {
 protected:
  Footprint() {
    // The squares of a chess board, each one texel of a picture of 64.
    Image board(64, 64, 3);
    for (int y = 0; y < 64; ++y) {
      for (int x = 0; x < 64; ++x) {
        for (int c = 0; c < 3; ++c) board.At(x, y, c) = static_cast<float>((x + y) % 2);
      }
    }
    const auto bytes = EncodeImage(board, ImageFormat::kPfm, {});
    testing_support::Put(folder_ / "board.pfm", *bytes);
  }

  /// A wall of that in z = -1, which shines as the sky of radiance 1 lets it. The spread of single
  /// samples around a point of it, and their mean.
  struct Look {
    double mean = 0, deviation = 0;
  };
  Look At(float spacing, const char* before = "") {
    const auto scene = CompileText(
        fmt::format("{}Background {{ color 1 1 1 }}\n"
                    "Textures {{ Texture {{ name board type image file board.pfm scale 4 4 }} }}\n"
                    "Materials {{ Material {{ type diffuse albedo texture board }} "
                    "Material {{ type diffuse albedo 1 1 1 }} }}\n"
                    "Scene {{ Node {{ Component<Object> {{ type plane normal 0 0 1 offset -1 }} "
                    "Component<Material> {{ index 0 }} }} {} }}",
                    testing_support::kCamera, before),
        folder_.path());
    IntegratorOptions options;
    options.bounces = 1;
    const PathIntegrator path(*scene, options);
    const auto workspace = path.MakeWorkspace();
    constexpr int kCount = 4096;
    std::vector<SampleRequest> requests(kCount);
    std::vector<Spectrum> radiance(kCount);
    for (int i = 0; i < kCount; ++i) {
      const double x = i * 0.7548776662466927, y = i * 0.5698402909980532;
      requests[i].index = static_cast<uint32_t>(i);
      requests[i].image_point = {static_cast<float>(x - std::floor(x)),
                                 static_cast<float>(y - std::floor(y))};
      requests[i].spacing = spacing;
    }
    path.Trace(requests, workspace.get(), SampleOutput{radiance});
    double sum = 0, squares = 0;
    for (const Spectrum& value : radiance) {
      sum += value[0];
      squares += value[0] * value[0];
    }
    const double mean = sum / kCount;
    return {mean, std::sqrt(std::max(0.0, squares / kCount - mean * mean))};
  }

  testing_support::TempFolder folder_;
};

// Pixels four squares apart, and pixels that are smaller than a hundredth of one.
TEST_F(Footprint, OfAPixelWithManySquaresIsTheirMean) {
  const Look far = At(4 / 256.0f);
  EXPECT_NEAR(far.mean, 0.5, 1e-3);
  EXPECT_LE(far.deviation, 1e-3);
}

TEST_F(Footprint, OfAPixelInASquareIsSharp) {
  const Look near = At(0.01f / 256), sharp = At(0);
  EXPECT_EQ(near.mean, sharp.mean);
  EXPECT_EQ(near.deviation, sharp.deviation);
  EXPECT_GT(near.deviation, 0.15);
}

// Many samples have the mean of one: the filter moves light, but makes none.
TEST_F(Footprint, OfAnySizeHasTheSameMean) {
  for (const float squares : {0.0f, 0.5f, 1.0f, 2.0f, 8.0f}) {
    EXPECT_NEAR(At(squares / 256).mean, 0.5, 5e-3) << squares;
  }
}

}  // namespace
}  // namespace candela
