// What holds for every texture.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <ostream>

#include "image/image_file.h"
#include "materials/material.h"
#include "tests/contract/rows.h"
#include "tests/support/temp_folder.h"
#include "textures/registry.h"

namespace candela {

inline void PrintTo(const TextureEntry& entry, std::ostream* out) {
  *out << entry.name;
}

namespace {

class EveryTexture : public testing::TestWithParam<TextureEntry> {
 protected:
  /// A scene whose only material is as bright as the texture.
  EveryTexture()
      : scene_(testing_support::CompileText(
            fmt::format("{}Textures {{ Texture {{ name t {} }} }}\n"
                        "Materials {{ Material {{ diffuse texture t }} }} Scene {{ }}",
                        testing_support::kCamera, GetParam().example),
            contract::kExampleFolder)) {}

  Rgb Lookup(Vec2 uv, float footprint = 0) const {
    SurfacePoint point;
    point.uv = uv;
    point.dpdu = {1, 0, 0};
    point.dpdv = {0, 1, 0};
    point.footprint = footprint;
    return scene_->materials()[0]->Phong(point).diffuse;
  }

  std::unique_ptr<const Scene> scene_;
};

INSTANTIATE_TEST_SUITE_P(Registry, EveryTexture,
                         testing::ValuesIn(TextureEntries().begin(), TextureEntries().end()),
                         contract::RowName<TextureEntry>);

TEST_P(EveryTexture, IsFiniteEverywhere) {
  constexpr float kOdd[] = {0,
                            0.3f,
                            1,
                            -1,
                            1e-38f,
                            1e10f,
                            -3e38f,
                            std::numeric_limits<float>::infinity(),
                            std::numeric_limits<float>::quiet_NaN()};
  for (const float u : kOdd) {
    for (const float v : kOdd) {
      for (const float footprint : kOdd) EXPECT_TRUE(IsFinite(Lookup({u, v}, footprint)));
    }
  }
}

TEST_P(EveryTexture, StandsWhereAColourMay) {
  EXPECT_GT(LengthSquared(Lookup({0.3f, 0.6f})), 0);
}

TEST_P(EveryTexture, SaysWhetherItNeedsCoordinates) {
  bool is_varied = false;
  for (int i = 1; i < 100; ++i) {
    const float x = static_cast<float>(i) / 100;
    is_varied = is_varied || Lookup({x, 1 - x / 2}) != Lookup({0, 0});
  }
  EXPECT_EQ(scene_->materials()[0]->NeedsTextureCoordinates(), is_varied);
}

/// What makes a texture of a type one colour: 0.2 0.4 0.6.
struct FlatTexture {
  std::string_view type;
  const char* params;
};
constexpr FlatTexture kFlatTextures[] = {
    {"constant", "color 0.2 0.4 0.6"},
    {"checker", "even 0.2 0.4 0.6 odd 0.2 0.4 0.6 scale 3 3"},
    {"image", "file flat.pfm scale 2 3 rotation 20"},
};

// Constant in gives constant out: nothing is lost or gained between texels and squares.
TEST_P(EveryTexture, OfOneColourShowsThatColourEverywhere) {
  const auto* flat =
      std::find_if(std::begin(kFlatTextures), std::end(kFlatTextures),
                   [](const FlatTexture& row) { return row.type == GetParam().name; });
  ASSERT_NE(flat, std::end(kFlatTextures)) << "say above how it becomes one colour";
  const testing_support::TempFolder folder;
  Image image(5, 3, 3);
  for (size_t i = 0; i < image.Samples().size(); ++i) {
    image.Samples()[i] = 0.2f * static_cast<float>(i % 3 + 1);
  }
  testing_support::Put(folder / "flat.pfm", *EncodeImage(image, ImageFormat::kPfm));
  scene_ = testing_support::CompileText(
      fmt::format("{}Textures {{ Texture {{ name t type {} {} }} }}\n"
                  "Materials {{ Material {{ diffuse texture t }} }} Scene {{ }}",
                  testing_support::kCamera, flat->type, flat->params),
      folder.path());
  for (int i = 0; i < 1000; ++i) {
    const auto x = static_cast<float>(i);
    const Rgb colour = Lookup({x * 0.037f - 10, 3 - x * 0.011f}, x * 0.002f);
    EXPECT_NEAR(colour.x, 0.2f, 1e-6f);
    EXPECT_NEAR(colour.y, 0.4f, 1e-6f);
    EXPECT_NEAR(colour.z, 0.6f, 1e-6f);
  }
}

}  // namespace
}  // namespace candela
