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
            fmt::format(
                "{}Textures {{ Texture {{ name squares type checker odd 0.2 0.2 0.2 scale 3 3 }}\n"
                "Texture {{ name t {} }} }}\n"
                "Materials {{ Material {{ diffuse texture t }} }} Scene {{ }}",
                testing_support::kCamera, GetParam().example),
            contract::kExampleFolder)) {}

  Rgb Lookup(Vec2 uv, float footprint = 0) const {
    SurfacePoint point;
    point.p = {uv.x, uv.y, uv.x - uv.y};
    point.n_geometric = point.n_shading = {0.6f, 0, 0.8f};
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

// Examples have colours from 0 to 1; nothing that is computed from them lies beyond.
TEST_P(EveryTexture, StaysWithinTheRangeOfItsColours) {
  for (int i = 0; i < 10000; ++i) {
    const auto x = static_cast<float>(i);
    const Rgb colour = Lookup({x * 0.037f - 10, 3 - x * 0.011f}, x * 0.0001f);
    for (int c = 0; c < 3; ++c) {
      ASSERT_GE(colour[c], -1e-6f);
      ASSERT_LE(colour[c], 1 + 1e-6f);
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

/// What makes a texture of a type one colour.
struct FlatTexture {
  std::string_view type;
  const char* params;
  Rgb color{0.2f, 0.4f, 0.6f};
};
constexpr FlatTexture kFlatTextures[] = {
    {"constant", "color 0.2 0.4 0.6"},
    {"checker", "even 0.2 0.4 0.6 odd 0.2 0.4 0.6 scale 3 3"},
    {"image", "file flat.pfm scale 2 3 rotation 20"},
    {"noise", "low 0.2 0.4 0.6 high 0.2 0.4 0.6 octaves 3"},
    {"turbulence", "low 0.2 0.4 0.6 high 0.2 0.4 0.6 scale 2 3 4"},
    {"marble", "low 0.2 0.4 0.6 high 0.2 0.4 0.6"},
    {"wood", "low 0.2 0.4 0.6 high 0.2 0.4 0.6"},
    {"voronoi", "low 0.2 0.4 0.6 high 0.2 0.4 0.6 feature cells"},
    {"ramp", "stops 0 0.2 0.4 0.6 1 0.2 0.4 0.6 wrap repeat"},
    {"uv", "scale 0 0 offset 0.2 0.4", {0.2f, 0.4f, 0}},
    {"mix", "first 0.2 0.4 0.6 second texture flat amount texture flat"},
    {"triplanar", "input texture flat"},
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
      fmt::format("{}Textures {{ Texture {{ name flat type image file flat.pfm }}\n"
                  "Texture {{ name t type {} {} }} }}\n"
                  "Materials {{ Material {{ diffuse texture t }} }} Scene {{ }}",
                  testing_support::kCamera, flat->type, flat->params),
      folder.path());
  for (int i = 0; i < 1000; ++i) {
    const auto x = static_cast<float>(i);
    const Rgb colour = Lookup({x * 0.037f - 10, 3 - x * 0.011f}, x * 0.002f);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(colour[c], flat->color[c], 1e-6f);
  }
}

}  // namespace
}  // namespace candela
