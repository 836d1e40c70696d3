// What is said about pictures that are broken, cut short, far too large, or hold what is no light:
// in the place of a texture, and around a scene.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <ostream>
#include <string>
#include <vector>

#include "image/image_file.h"
#include "image/png_write.h"
#include "tests/image/png_builder.h"
#include "tests/support/temp_folder.h"
#include "tests/textures/make_texture.h"
#include "textures/environment_map.h"

namespace candela {
namespace {

using test::At;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::string Encoded(const Image& image, ImageFormat format) {
  const auto bytes = EncodeImage(image, format);
  EXPECT_TRUE(bytes.ok());
  return *bytes;
}

std::string Little(uint32_t value) {
  std::string bytes;
  for (int shift = 0; shift < 32; shift += 8) bytes.push_back(static_cast<char>(value >> shift));
  return bytes;
}

/// Pixels on each side of a picture that is far too large; no JPEG file promises more.
int HugeSide(ImageFormat format) {
  return format == ImageFormat::kJpeg ? 65500 : 100000;
}

/// A small file whose frame header says other sides.
std::string HugeJpeg() {
  std::string jpeg = Encoded(Image(2, 2, 3, 1.0f), ImageFormat::kJpeg);
  const size_t frame = jpeg.find("\xff\xc0");
  EXPECT_NE(frame, jpeg.npos);
  return jpeg.replace(frame + 5, 4, "\xff\xdc\xff\xdc");
}

/// A file with a header that promises so many pixels and little else.
std::string Huge(ImageFormat format) {
  switch (format) {
    case ImageFormat::kJpeg:
      return HugeJpeg();
    case ImageFormat::kPng:
      return PngOf(PngHeader(100000, 100000, 8, 2), "");
    case ImageFormat::kPfm:
      return "PF\n100000 100000\n-1\n" + std::string(100, '\0');
    case ImageFormat::kHdr:
      return "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 100000 +X 100000\n" + std::string(100, '\1');
    default:
      break;
  }
  // An EXR file says the corners of its windows: the last ones become 99,999.
  std::string exr = Encoded(Image(2, 2, 3, 1.0f), format);
  const std::string corners = Little(0) + Little(0) + Little(1) + Little(1);
  for (size_t at = exr.find(corners); at != exr.npos; at = exr.find(corners)) {
    exr.replace(at + 8, 8, Little(99999) + Little(99999));
  }
  return exr;
}

struct FormatRow {
  const char* extension;
  ImageFormat format;
};
void PrintTo(const FormatRow& row, std::ostream* out) {
  *out << row.extension;
}

/// A place where a scene may name a picture.
class BadPicture : public testing::TestWithParam<FormatRow> {
 protected:
  std::string Name() const { return std::string("a.") + GetParam().extension; }

  /// The messages about a file in either place; nothing may come of it.
  void ExpectRefused(const std::string& bytes, const std::string& message) {
    testing_support::Put(folder_ / Name(), bytes);
    EXPECT_THAT(AsTexture(), ElementsAre(HasSubstr(message)));
    EXPECT_EQ(texture_, nullptr);
    EXPECT_THAT(AsEnvironment(), ElementsAre(HasSubstr(message)));
    EXPECT_FALSE(map_);
  }

  std::vector<std::string> AsTexture() {
    Diagnostics diagnostics;
    texture_ = test::MakeTexture("image", "file " + Name() + " encoding linear", folder_.path(),
                                 &diagnostics);
    return diagnostics.Lines();
  }
  std::vector<std::string> AsEnvironment() {
    Diagnostics diagnostics;
    map_ = EnvironmentMap::Load(folder_ / Name(), {}, 1, 0, &diagnostics);
    return diagnostics.Lines();
  }

  testing_support::TempFolder folder_;
  std::shared_ptr<const Texture> texture_;
  std::optional<EnvironmentMap> map_;
};

INSTANTIATE_TEST_SUITE_P(Formats, BadPicture,
                         testing::Values(FormatRow{"png", ImageFormat::kPng},
                                         FormatRow{"jpg", ImageFormat::kJpeg},
                                         FormatRow{"exr", ImageFormat::kExr},
                                         FormatRow{"hdr", ImageFormat::kHdr},
                                         FormatRow{"pfm", ImageFormat::kPfm}),
                         [](const auto& row) { return std::string(row.param.extension); });

TEST_P(BadPicture, ThatIsFarTooLargeIsRefusedBeforeMemoryIsTaken) {
  const int side = HugeSide(GetParam().format);
  ExpectRefused(Huge(GetParam().format), fmt::format("a picture of {0} x {0} pixels", side));
}

TEST_P(BadPicture, CutAnywhereIsRefused) {
  Image image(5, 4, 3);
  for (size_t i = 0; i < image.Samples().size(); ++i) {
    image.Samples()[i] = static_cast<float>(i) / 64;
  }
  const std::string whole = Encoded(image, GetParam().format);
  for (size_t length = 0; length < whole.size(); length += 1 + length / 8) {
    testing_support::Put(folder_ / Name(), whole.substr(0, length));
    EXPECT_THAT(AsTexture(), testing::Not(IsEmpty())) << length;
    EXPECT_THAT(AsEnvironment(), testing::Not(IsEmpty())) << length;
    // A PNG file that lacks no more than its end is still a picture, with a warning.
    if (GetParam().format == ImageFormat::kPng && length + 12 >= whole.size()) continue;
    EXPECT_EQ(texture_, nullptr) << length;
    EXPECT_FALSE(map_) << length;
  }
}

TEST_P(BadPicture, ThatIsEmptyOrATextIsRefused) {
  ExpectRefused("", "this is not a PNG, JPEG, EXR, HDR or PFM");
  ExpectRefused("no picture", "this is not a PNG, JPEG, EXR, HDR or PFM");
}

// Every lookup falls beyond an edge, on all sides.
TEST_P(BadPicture, OfOnePixelHasItsColourEverywhere) {
  testing_support::Put(folder_ / Name(), Encoded(Image(1, 1, 3, 1.0f), GetParam().format));
  EXPECT_THAT(AsTexture(), IsEmpty());
  EXPECT_THAT(AsEnvironment(), IsEmpty());
  for (const float u : {-7.3f, -1.0f, 0.0f, 0.5f, 1.0f, 1e9f}) {
    EXPECT_EQ(texture_->Lookup(At(u, 0.25f - u)), (Rgb{1, 1, 1})) << u;
  }
  for (const Vec3 w : {Vec3{0, 1, 0}, Vec3{0, -1, 0}, Vec3{0, 0, 1}, Vec3{-0.6f, 0, -0.8f}}) {
    EXPECT_EQ(map_->Lookup(w), (Rgb{1, 1, 1}));
  }
}

/// The formats that hold any float.
class FloatPicture : public BadPicture {
 protected:
  void PutWith(float value) {
    Image image(3, 2, 3, 0.25f);
    image.At(2, 1, 0) = value;
    testing_support::Put(folder_ / Name(), Encoded(image, GetParam().format));
  }
};

INSTANTIATE_TEST_SUITE_P(Formats, FloatPicture,
                         testing::Values(FormatRow{"exr", ImageFormat::kExr},
                                         FormatRow{"pfm", ImageFormat::kPfm}),
                         [](const auto& row) { return std::string(row.param.extension); });

// The light of an environment has to be a number; of a texture the texel counts as 0, and that is
// said.
TEST_P(FloatPicture, WithAPixelThatIsNotFiniteIsNoEnvironmentAndADarkTexel) {
  for (const float value :
       {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
        -std::numeric_limits<float>::infinity()}) {
    PutWith(value);
    EXPECT_THAT(AsEnvironment(),
                ElementsAre(HasSubstr("error: pixel (2, 1) of the environment is not a finite "
                                      "number")));
    EXPECT_FALSE(map_);
    EXPECT_THAT(AsTexture(),
                ElementsAre(HasSubstr("warning: 1 value of the texture became 0; it was not a "
                                      "finite number")));
    ASSERT_NE(texture_, nullptr);
    EXPECT_EQ(texture_->Lookup(At(5 / 6.0f, 0.25f)), (Rgb{0, 0.25f, 0.25f}));
  }
}

TEST_P(FloatPicture, WithNegativeLightIsMendedWithAWarning) {
  PutWith(-3);
  EXPECT_THAT(AsEnvironment(),
              ElementsAre(HasSubstr("warning: 1 negative value of the environment became 0")));
  ASSERT_TRUE(map_);
  for (const float mean : map_->MeansOfCells()) EXPECT_GE(mean, 0);
}

}  // namespace
}  // namespace candela
