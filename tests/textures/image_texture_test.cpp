#include "textures/image_texture.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "image/image_file.h"
#include "image/png_write.h"
#include "tests/support/temp_folder.h"
#include "tests/textures/make_texture.h"

namespace candela {
namespace {

using test::At;
using test::MakeTexture;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing_support::Put;
using testing_support::TempFolder;

class ImageTextureTest : public testing::Test {
 protected:
  /// A texture of these parameters, with files in the folder; null when there are messages.
  std::shared_ptr<const Texture> Make(const std::string& text) {
    Diagnostics diagnostics;
    auto texture = MakeTexture("image", text, folder_.path(), &diagnostics);
    lines_ = diagnostics.Lines();
    return texture;
  }

  /// A grey picture of one texel.
  void PutGrey(const std::string& name, uint8_t level) {
    Put(folder_ / name, EncodePng(ByteImage(1, 1, 1, level)).value());
  }

  TempFolder folder_;
  std::vector<std::string> lines_;
};

// 188 of 255 is half of the light.
TEST_F(ImageTextureTest, PngIsMadeForEyes) {
  PutGrey("a.png", 188);
  EXPECT_NEAR(Make("file a.png")->Lookup(At(0, 0)).x, 0.5029, 1e-4);
  EXPECT_NEAR(Make("file a.png encoding linear")->Lookup(At(0, 0)).y, 188 / 255.0, 1e-6);
  EXPECT_NEAR(Make("file a.png encoding srgb")->Lookup(At(0, 0)).z, 0.5029, 1e-4);
  PutGrey("black.png", 5);
  EXPECT_NEAR(Make("file black.png")->Lookup(At(0, 0)).x, 5 / 255.0 / 12.92, 1e-6);
}

TEST_F(ImageTextureTest, FloatsHoldLight) {
  for (const auto& [name, format] :
       {std::pair{"a.exr", ImageFormat::kExr}, std::pair{"a.pfm", ImageFormat::kPfm},
        std::pair{"a.hdr", ImageFormat::kHdr}}) {
    Put(folder_ / name, EncodeImage(Image(2, 1, 3, 4.0f), format).value());
    EXPECT_EQ(Make(std::string("file ") + name)->Lookup(At(0.3f, 0.2f)), (Rgb{4, 4, 4})) << name;
  }
}

TEST_F(ImageTextureTest, CoordinatesAreScaledTurnedAndMoved) {
  ByteImage image(4, 1, 1);
  for (int x = 0; x < 4; ++x) image.At(x, 0) = static_cast<uint8_t>(51 * x);
  Put(folder_ / "ramp.png", EncodePng(image).value());
  const auto column = [&](const std::string& text, float u, float v) {
    return Make("file ramp.png encoding linear " + text)->Lookup(At(u, v)).x * 5;
  };
  EXPECT_NEAR(column("", 0.375f, 0), 1, 1e-5);
  EXPECT_NEAR(column("scale 3 1", 0.125f, 0), 1, 1e-5);
  EXPECT_NEAR(column("offset 0.25 0", 0.125f, 0), 1, 1e-5);
  EXPECT_NEAR(column("rotation 90", 0, 0.375f), 2, 1e-5) << "u becomes -v";
}

// The picture is one unit of u wide, and u is two units of length: 2 of 4 texels.
TEST_F(ImageTextureTest, AFootprintIsAMean) {
  ByteImage image(4, 4, 1);
  for (int y = 0; y < 4; ++y) {
    for (int x = 0; x < 4; ++x) image.At(x, y) = x % 2 == 0 ? 255 : 0;
  }
  Put(folder_ / "stripes.png", EncodePng(image).value());
  const auto texture = Make("file stripes.png encoding linear");
  SurfacePoint point = At(0.125f, 0.125f);
  point.dpdu = {2, 0, 0};
  point.dpdv = {0, 2, 0};
  EXPECT_EQ(texture->Lookup(point).x, 1);
  point.footprint = 1;
  EXPECT_EQ(texture->Lookup(point).x, 0.5f);
}

TEST_F(ImageTextureTest, SaysWhatIsWrong) {
  EXPECT_EQ(Make("file none.png"), nullptr);
  EXPECT_THAT(lines_, ElementsAre(HasSubstr("none.png': no such file")));
  Put(folder_ / "broken.png", "no picture");
  EXPECT_EQ(Make("file broken.png"), nullptr);
  EXPECT_THAT(lines_, ElementsAre(HasSubstr("broken.png'")));
  PutGrey("a.png", 1);
  Make("file a.png wrap round");
  EXPECT_THAT(lines_, ElementsAre(HasSubstr("'wrap' expects 'repeat', 'mirror' or 'clamp', found "
                                            "'round'")));
  Make("file a.png encoding gamma");
  EXPECT_THAT(lines_, ElementsAre(HasSubstr("'encoding' expects 'srgb' or 'linear', found")));
  Make("file a.png scale 3");
  EXPECT_THAT(lines_, ElementsAre(HasSubstr("'scale' expects two numbers, found 1 number")));
  Make("");
  EXPECT_THAT(lines_, ElementsAre(HasSubstr("'image' needs 'file'")));
}

}  // namespace
}  // namespace candela
