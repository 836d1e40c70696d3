// candela compare, run as a user does.

#include "base/files.h"
#include "tests/apps/programs.h"

namespace candela::testing_support {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// Two pictures of 4 x 2 pixels: one grey, the other with a single channel of one pixel changed.
class CompareTest : public ProgramTest {
 protected:
  CompareTest() {
    Image picture(4, 2, 3, 0.5f);
    Write("a.pfm", picture);
    picture.At(1, 1, 2) = 0.75f;
    Write("b.pfm", picture);
    Write("small.pfm", Image(2, 2, 3));
  }
  void Write(const std::string& name, const Image& image) {
    const auto bytes = EncodeImage(image, *FormatOf(name));
    ASSERT_TRUE(bytes.ok());
    Put(folder_ / name, *bytes);
  }
  ProgramEnd Compare(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), "compare");
    return Candela(arguments);
  }
};

TEST_F(CompareTest, PrintsHowFarPicturesAreApart) {
  const ProgramEnd end = Compare({"a.pfm", "b.pfm"});
  EXPECT_EQ(end.status, 0);
  EXPECT_EQ(end.err, "");
  // MSE = (1/4)^2 / 24 values; PSNR = 10 log10(384) = 25.84.
  EXPECT_EQ(end.out,
            "PSNR        25.84 dB\n"
            "MSE         0.00260417\n"
            "differing   1 of 8 pixels (12.5%), 1 by more than 1/255\n"
            "largest     0.25 (63.75 levels of 1/255)\n");
}

TEST_F(CompareTest, EqualPicturesPassEveryThreshold) {
  const ProgramEnd end = Compare(
      {"a.pfm", "a.pfm", "--min-psnr", "1000", "--max-pixels", "0", "--max-difference", "0"});
  EXPECT_EQ(end.status, 0);
  EXPECT_THAT(end.out, testing::StartsWith("PSNR        equal\n"));
}

TEST_F(CompareTest, ThresholdsDecideTheExitStatus) {
  EXPECT_EQ(Compare({"a.pfm", "b.pfm", "--min-psnr", "25.8"}).status, 0);
  EXPECT_EQ(Compare({"a.pfm", "b.pfm", "--min-psnr", "25.9"}).status, 6);
  EXPECT_EQ(Compare({"a.pfm", "b.pfm", "--max-pixels", "1"}).status, 0);
  EXPECT_EQ(Compare({"a.pfm", "b.pfm", "--max-pixels", "0"}).status, 6);
  EXPECT_EQ(Compare({"a.pfm", "b.pfm", "--max-difference", "63.75"}).status, 0);
  const ProgramEnd end =
      Compare({"a.pfm", "b.pfm", "--max-difference", "63.7", "--min-psnr", "30"});
  EXPECT_EQ(end.status, 6);
  EXPECT_THAT(end.out, HasSubstr("\nbeyond: PSNR is below 30 dB\n"));
  EXPECT_THAT(end.out, HasSubstr("\nbeyond: a channel differs by more than 63.7 levels\n"));
  EXPECT_EQ(end.err, "");
}

// The values of bytes are rounded floats; their distance is a whole number of levels all the same.
TEST_F(CompareTest, WholeLevelsAreWithinThatManyLevels) {
  for (const int levels : {1, 3, 100}) {
    for (const int value : {0, 7, 155}) {
      Write("a.png", Image(1, 1, 3, static_cast<float>(value) / 255));
      Write("b.png", Image(1, 1, 3, static_cast<float>(value + levels) / 255));
      const auto status = [&](double allowed) {
        return Compare({"a.png", "b.png", "--max-difference", std::to_string(allowed)}).status;
      };
      EXPECT_EQ(status(levels), 0) << value << ", " << levels;
      EXPECT_EQ(status(levels - 0.5), 6) << value << ", " << levels;
    }
  }
}

TEST_F(CompareTest, WritesAPictureOfTheDifferences) {
  EXPECT_EQ(Compare({"a.pfm", "b.pfm", "--difference", "d.pfm"}).status, 0);
  EXPECT_EQ(Picture("d.pfm").At(1, 1, 2), 0.25f);
  EXPECT_EQ(Picture("d.pfm").At(1, 1, 1), 0.0f);
  EXPECT_EQ(Compare({"a.pfm", "b.pfm", "--difference", "d.pfm", "--gain", "10"}).status, 0);
  EXPECT_EQ(Picture("d.pfm").At(1, 1, 2), 2.5f);
}

TEST_F(CompareTest, RefusesWhatCannotBeCompared) {
  const auto refused = [&](const std::vector<std::string>& arguments, int status,
                           const std::string& message) {
    ExpectRefusal(Compare(arguments), status, "candela compare: error: " + message);
  };
  refused({"a.pfm", "small.pfm"}, 1, "the sizes differ: 4 x 2 and 2 x 2");
  refused({"a.pfm", "missing.png"}, 1, "'missing.png': no such file");
  refused({"a.pfm"}, 2, "B is missing");
  refused({"a.pfm", "b.pfm", "--gain", "2"}, 2, "--gain goes with --difference only");
  refused({"a.pfm", "b.pfm", "--difference", "./b.pfm"}, 2,
          "--difference: './b.pfm' is one of the pictures to compare");
  refused({"a.pfm", "b.pfm", "--min-psnr", "-3"}, 2,
          "--min-psnr: expects a number of at least 0, found '-3'");
  refused({"a.pfm", "b.pfm", "--max-pixel", "3"}, 2,
          "unknown option '--max-pixel' (did you mean '--max-pixels'?)");
  EXPECT_THAT(folder_.Names(), ElementsAre("a.pfm", "b.pfm", "scene.txt", "small.pfm"));
}

}  // namespace
}  // namespace candela::testing_support
