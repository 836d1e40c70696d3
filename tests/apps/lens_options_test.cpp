// What `candela render` does to the finished picture, run as a user does: exposure as a camera has
// it, bloom and vignette.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "image/exr.h"
#include "tests/apps/programs.h"

namespace candela::testing_support {
namespace {

using testing::HasSubstr;
using testing::Not;

/// A small even light in front of nothing.
class LensOptionsTest : public ProgramTest {
 protected:
  void PutDot(const std::string& settings = "", const std::string& camera = "fov 90") const {
    Put(folder_ / "dot.txt",
        settings + "Camera { center 0 0 0 direction 0 0 -1 up 0 1 0 " + camera +
            " }\nBackground { ambient_light 4 2 1 }\n"
            "Materials { Material { diffuse 1 1 1 } }\n"
            "Scene { Transform { translate 0 0 -10 } Component<Object> { type sphere radius 0.6 }\n"
            "        Component<Material> { index 0 } }\n");
  }
  /// Everything even, with a light of 0.5.
  void PutSky(const std::string& settings = "", const std::string& camera = "fov 90") const {
    Put(folder_ / "dot.txt", settings + "Camera { center 0 0 0 direction 0 0 -1 up 0 1 0 " +
                                 camera + " }\nBackground { color 0.5 0.5 0.5 }\nScene { }\n");
  }
  ProgramEnd Render(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), {"render", "dot.txt", "--quiet", "--pixel-grid=centres"});
    if (std::find(arguments.begin(), arguments.end(), "--size") == arguments.end()) {
      arguments.insert(arguments.end(), {"--size", "61", "61"});
    }
    return Candela(arguments);
  }
  Image Rendered(std::vector<std::string> arguments, const std::string& file = "o.pfm") const {
    arguments.insert(arguments.end(), {"-o", file});
    const ProgramEnd end = Render(arguments);
    EXPECT_EQ(end.err, "");
    EXPECT_EQ(end.status, 0);
    return Picture(file);
  }
  void ExpectUsageError(const std::vector<std::string>& arguments, const std::string& message) {
    ExpectRefusal(Render(arguments), 2, "candela render: error: " + message);
  }
};

double SumOf(const Image& picture) {
  double sum = 0;
  for (const float value : picture.Samples()) sum += static_cast<double>(value);
  return sum;
}

TEST_F(LensOptionsTest, BloomKeepsTheLightAndSpreadsIt) {
  PutDot();
  const Image plain = Rendered({}), bloom = Rendered({"--bloom", "0.25", "0.3"});
  EXPECT_NEAR(SumOf(bloom), SumOf(plain), 1e-5 * SumOf(plain));
  EXPECT_EQ(plain.At(30, 30, 0), 4);
  EXPECT_LT(bloom.At(30, 30, 0), 4);
  EXPECT_GT(bloom.At(30, 30, 0), 3);
  EXPECT_EQ(plain.At(30, 20, 0), 0);
  // 0.3 times 61 pixels around the dot, whose radius is two.
  EXPECT_GT(bloom.At(30, 14, 0), 0);
  EXPECT_EQ(bloom.At(30, 8, 0), 0);
  for (int i = 0; i < 61; ++i) {
    EXPECT_NEAR(bloom.At(i, 30, 0), bloom.At(60 - i, 30, 0), 1e-6);
    EXPECT_NEAR(bloom.At(i, 30, 0), bloom.At(30, i, 0), 1e-5);
    EXPECT_NEAR(bloom.At(i, 30, 0), 4 * bloom.At(i, 30, 2), 1e-5);
  }
}

TEST_F(LensOptionsTest, OfNoStrengthTheyChangeNoByte) {
  PutDot();
  for (const char* file : {"a.png", "a.jpg", "a.exr", "a.hdr", "a.pfm"}) {
    Rendered({}, file);
    const std::string plain = Bytes(file);
    Rendered({"--bloom", "0", "0.5", "--vignette", "0"}, file);
    EXPECT_EQ(Bytes(file), plain) << file;
    Rendered({"--bloom", "0.5", "0"}, file);
    EXPECT_EQ(Bytes(file), plain) << file;
    Rendered({"--bloom", "0.5", "0.5"}, file);
    EXPECT_NE(Bytes(file), plain) << file;
  }
}

// Only the colours change; the file tells it.
TEST_F(LensOptionsTest, BloomLeavesLayersAlone) {
  PutDot();
  Rendered({"--aov", "all"}, "plain.exr");
  Rendered({"--aov", "all", "--bloom", "0.5", "0.3", "--vignette", "1"}, "bloom.exr");
  const auto plain = DecodeExrChannels(Bytes("plain.exr"));
  const auto bloom = DecodeExrChannels(Bytes("bloom.exr"));
  ASSERT_TRUE(plain && bloom);
  ASSERT_EQ(plain->channels, bloom->channels);
  for (size_t c = 0; c < plain->channels.size(); ++c) {
    bool is_same = true;
    for (int i = 0; i < 61 * 61; ++i) {
      is_same = is_same && plain->image.At(i % 61, i / 61, static_cast<int>(c)) ==
                               bloom->image.At(i % 61, i / 61, static_cast<int>(c));
    }
    EXPECT_EQ(is_same, plain->channels[c].size() > 1) << plain->channels[c];
  }
  EXPECT_THAT(Bytes("bloom.exr"), HasSubstr(" --bloom 0.5 0.3 --vignette 1"));
  EXPECT_THAT(Bytes("plain.exr"), Not(HasSubstr("--bloom")));
}

// The radius is that of the whole picture, and light beyond the crop is not there.
TEST_F(LensOptionsTest, BloomOfACropSpreadsWhatItHolds) {
  PutDot();
  const Image whole = Rendered({"--bloom", "0.5", "0.2"});
  const Image crop = Rendered({"--bloom", "0.5", "0.2", "--crop", "10", "5", "51", "56"});
  ASSERT_EQ(crop.Width(), 41);
  for (int y = 0; y < crop.Height(); ++y) {
    for (int x = 0; x < crop.Width(); ++x) {
      EXPECT_EQ(crop.At(x, y, 1), whole.At(x + 10, y + 5, 1)) << x << " " << y;
    }
  }
  EXPECT_EQ(SumOf(Rendered({"--bloom", "0.5", "0.2", "--crop", "0", "0", "61", "20"})), 0);
}

TEST_F(LensOptionsTest, BloomComesBeforeTheToneCurve) {
  PutDot();
  const Image light = Rendered({"--bloom", "0.3", "0.2"});
  const Image shown = Rendered({"--bloom", "0.3", "0.2", "--exposure", "-1"}, "o.png");
  for (const int x : {30, 34, 36}) {
    EXPECT_NEAR(shown.At(x, 30, 0), std::min(1.0f, light.At(x, 30, 0) / 2), 0.5f / 255 + 1e-6f);
  }
}

TEST_F(LensOptionsTest, BloomDoesNotDependOnThreadsAndGoesWithCheckpoints) {
  PutDot();
  const Image one = Rendered({"--bloom", "0.3", "0.4", "--threads", "1"});
  EXPECT_EQ(Rendered({"--bloom", "0.3", "0.4", "--threads", "3"}), one);
  // A checkpoint holds the light before the lens, so that another bloom may come later.
  EXPECT_EQ(Rendered({"--bloom", "0.9", "0.1", "--checkpoint", "c"}),
            Rendered({"--bloom", "0.9", "0.1"}));
  EXPECT_EQ(Rendered({"--bloom", "0.3", "0.4", "--checkpoint", "c"}), one);
}

// 45 degrees off the axis there is a quarter of the light: the edges of this picture.
TEST_F(LensOptionsTest, VignetteIsTheFourthPowerOfTheCosine) {
  PutSky();
  const Image full = Rendered({"--vignette", "1"}), half = Rendered({"--vignette", "0.5"});
  for (int x = 0; x < 61; ++x) {
    const double tangent = (x - 30) / 30.5;
    const double expected = 0.5 / std::pow(1 + tangent * tangent, 2);
    EXPECT_NEAR(full.At(x, 30, 0), expected, 1e-6);
    EXPECT_NEAR(full.At(30, x, 2), expected, 1e-6);
    EXPECT_NEAR(half.At(x, 30, 1), (0.5 + expected) / 2, 1e-6);
  }
  EXPECT_EQ(full.At(30, 30, 0), 0.5f);
}

// The axis is that of the lens, wherever the window of the picture is, and whatever part of it.
TEST_F(LensOptionsTest, VignetteFollowsTheShift) {
  PutSky("", "fov 90 shift 1 0");
  const Image shifted = Rendered({"--vignette", "1"});
  EXPECT_NEAR(shifted.At(30, 30, 0), 0.125, 1e-6);
  const Image crop = Rendered({"--vignette", "1", "--crop", "30", "20", "40", "40"});
  EXPECT_EQ(crop.At(0, 10, 0), shifted.At(30, 30, 0));
}

// Light of 0.5 candela per square metre at 100 ISO, f/1 and 2.4 seconds: 0.65 2.4 100 / 78 = 2.
TEST_F(LensOptionsTest, ExposureMayBeThatOfACamera) {
  PutSky();
  const auto value = [&](const std::vector<std::string>& options) {
    return Rendered(options, "o.png").At(30, 30, 0);
  };
  const float step = 0.5f / 255 + 1e-6f;
  EXPECT_NEAR(value({"--f-stop", "1", "--shutter", "1.2"}), 0.5f, step);
  EXPECT_NEAR(value({"--f-stop", "1", "--shutter", "0.6"}), 0.25f, step);
  EXPECT_NEAR(value({"--f-stop", "2", "--shutter", "1.2", "--iso", "300"}), 0.375f, step);
  EXPECT_NEAR(value({"--f-stop", "4", "--shutter", "2.4"}), 0.0625f, step);
  // Sunny 16: a white sheet under the sun, of the luminance 1e5 / pi, is 0.83 at 1/100 s.
  const double sunny = 0.65 * 0.01 * 100 / (78 * 16 * 16) * 1e5 / M_PI;
  EXPECT_NEAR(sunny, 1.036, 0.001);
}

TEST_F(LensOptionsTest, ScenesMaySetThem) {
  PutSky();
  const Image expected = Rendered({"--f-stop", "2", "--shutter", "3", "--iso", "200"}, "o.png");
  const Image lens = Rendered({"--bloom", "0.3", "0.2", "--vignette", "0.5"});
  PutSky("Film { iso 200 f_stop 2 shutter 3 }\n");
  EXPECT_EQ(Rendered({}, "o.png"), expected);
  EXPECT_EQ(Rendered({"--exposure", "0"}, "o.png").At(30, 30, 0), 127 / 255.0f);
  PutSky("Film { exposure 3 }\n");
  EXPECT_EQ(Rendered({"--f-stop", "2", "--shutter", "3", "--iso", "200"}, "o.png"), expected);
  PutSky("Film { f_stop 2 shutter 9 }\n");
  EXPECT_EQ(Rendered({"--shutter", "3", "--iso", "200"}, "o.png"), expected);
  PutSky("Film { bloom 0.3 0.2 vignette 0.5 }\n");
  EXPECT_EQ(Rendered({}), lens);
  EXPECT_NE(Rendered({"--bloom", "0", "0"}), lens);
}

TEST_F(LensOptionsTest, ResolvedScenesHoldThem) {
  PutSky("Film { f_stop 2 shutter 3 bloom 0.25 0.5 }\n");
  const ProgramEnd resolved = Candela({"info", "--resolved", "dot.txt"});
  for (const char* line : {"iso 100", "f_stop 2", "shutter 3", "bloom 0.25 0.5"}) {
    EXPECT_THAT(resolved.out, HasSubstr(fmt::format("\n  {}\n", line)));
  }
  EXPECT_THAT(resolved.out, Not(HasSubstr("exposure")));
  Put(folder_ / "resolved.txt", resolved.out);
  EXPECT_EQ(Candela({"info", "--resolved", "resolved.txt"}).out, resolved.out);
}

TEST_F(LensOptionsTest, WhatDoesNotGoTogetherIsPlacedInScenes) {
  const auto checked = [&](const std::string& settings, const std::string& camera = "fov 90") {
    PutSky(settings + "\n", camera);
    const ProgramEnd end = Candela({"check", "dot.txt"});
    EXPECT_EQ(end.status, 1);
    EXPECT_EQ(Render({"-o", "no.pfm"}).err, end.err);
    return end.err;
  };
  EXPECT_EQ(checked("Film { exposure 1 f_stop 2 shutter 3 }"),
            "dot.txt:1:19: error: 'f_stop' and 'exposure': give one of them\n");
  EXPECT_EQ(checked("Film { iso 400 }"),
            "dot.txt:1:8: error: 'iso' needs 'f_stop' and 'shutter' beside it\n");
  EXPECT_EQ(checked("Film { iso 400 f_stop 2 }"),
            "dot.txt:1:8: error: 'iso' needs 'shutter' beside it\n");
  EXPECT_EQ(checked("Film { vignette 0.5 }", "type fisheye"),
            "dot.txt:1:8: error: 'vignette' is for a camera of the type 'perspective'\n");
  EXPECT_EQ(checked("Film { f_stop 0 shutter 1 }"),
            "dot.txt:1:15: error: 'f_stop' expects a number above 0, found '0'\n");
  EXPECT_EQ(checked("Film { bloom 0.5 }"),
            "dot.txt:1:8: error: 'bloom' expects 2 values: STRENGTH RADIUS, found 1 number\n");
}

TEST_F(LensOptionsTest, WhatDoesNotGoTogetherIsRefused) {
  PutSky();
  ExpectUsageError({"-o", "o.png", "--exposure", "1", "--iso", "100"},
                   "--exposure and --iso: give one of them");
  ExpectUsageError({"-o", "o.png", "--iso", "100"},
                   "--iso: an exposure as a camera has it takes --f-stop and --shutter");
  ExpectUsageError({"-o", "o.exr", "--f-stop", "2", "--shutter", "1"},
                   "--f-stop is for .png and .jpg files; the others hold the light itself");
  ExpectUsageError({"--normals", "n.png", "--bloom", "0.5", "0.1"},
                   "--bloom is for the picture of --output: give both");
  ExpectUsageError({"-o", "o.png", "--bloom", "1.5", "0.1"},
                   "--bloom: expects a number from 0 to 1 for STRENGTH, found '1.5'");
  ExpectUsageError({"-o", "o.png", "--bloom", "0.5", "-1"},
                   "--bloom: expects a number from 0 to 1 for RADIUS, found '-1'");
  ExpectUsageError({"-o", "o.png", "--shutter", "nan"},
                   "--shutter: expects a number above 0, found 'nan'");
  PutSky("", "type panoramic");
  ExpectUsageError({"-o", "o.png", "--vignette", "0.5"},
                   "--vignette is for a camera of the type 'perspective'");
}

}  // namespace
}  // namespace candela::testing_support
