// What holds for every texture.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <ostream>

#include "materials/material.h"
#include "tests/contract/rows.h"
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

}  // namespace
}  // namespace candela
