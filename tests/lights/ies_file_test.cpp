#include "lights/ies_file.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "base/files.h"
#include "math/elementary.h"

namespace candela {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::optional<IesFile> Parse(const std::string& text, std::vector<std::string>* lines = nullptr) {
  Diagnostics diagnostics;
  auto file = ParseIes(std::make_shared<const std::string>("lamp.ies"), text, &diagnostics);
  if (lines) *lines = diagnostics.Lines();
  EXPECT_EQ(file.has_value(), !diagnostics.HasErrors());
  return file;
}

/// What is reported about a text.
std::vector<std::string> Report(const std::string& text) {
  std::vector<std::string> lines;
  Parse(text, &lines);
  return lines;
}

/// A lamp of a table; `angles` are the vertical ones and the horizontal ones.
std::string Lamp(int vertical, int horizontal, const std::string& angles,
                 const std::string& candela) {
  return fmt::format(
      "IESNA:LM-63-1995\n[TEST] 1\nTILT=NONE\n1 1000 1 {} {} 1 2 0 0 0\n1 1 10\n{}\n{}\n", vertical,
      horizontal, angles, candela);
}

/// The intensity in the directions of a vertical and some horizontal angles.
std::vector<float> Around(const IesFile& file, const std::vector<double>& horizontal) {
  std::vector<float> intensities;
  for (const double angle : horizontal) {
    const double sine = SinDegrees(90), cosine = CosDegrees(90);
    const Vec3d w{sine * CosDegrees(angle), sine * SinDegrees(angle), cosine};
    intensities.push_back(file.profile.Intensity(ToFloat(w)));
  }
  return intensities;
}

testing::Matcher<const std::vector<float>&> Are(const std::vector<float>& values) {
  return testing::Pointwise(testing::FloatNear(1e-3f), values);
}

TEST(Ies, OfOneHorizontalAngleIsTheSameAllAround) {
  const auto file = Parse(Lamp(3, 1, "0 90 180\n0", "1 2 3"));
  ASSERT_TRUE(file);
  EXPECT_THAT(Around(*file, {0, 37, 180, 300}), Are({2, 2, 2, 2}));
  EXPECT_FLOAT_EQ(file->profile.Intensity({0, 0, 1}), 1);
  EXPECT_FLOAT_EQ(file->profile.Intensity({0, 0, -1}), 3);
}

TEST(Ies, OfAQuadrantIsSymmetricToBothPlanes) {
  const auto file = Parse(Lamp(2, 3, "0 90\n0 30 90", "1 2\n1 4\n1 8"));
  ASSERT_TRUE(file);
  EXPECT_THAT(Around(*file, {0, 30, 90, 150, 180, 210, 270, 330, 345}),
              Are({2, 4, 8, 4, 2, 4, 8, 4, 3}));
}

TEST(Ies, OfAHalfIsSymmetricToThePlaneOf0) {
  const auto file = Parse(Lamp(2, 3, "0 90\n0 45 180", "1 2\n1 4\n1 8"));
  ASSERT_TRUE(file);
  EXPECT_THAT(Around(*file, {0, 45, 180, 315, 337.5}), Are({2, 4, 8, 4, 3}));
}

TEST(Ies, OfTheOtherHalfIsSymmetricToThePlaneOf90) {
  const auto file = Parse(Lamp(2, 3, "0 90\n90 120 270", "1 2\n1 4\n1 8"));
  ASSERT_TRUE(file);
  EXPECT_THAT(Around(*file, {90, 120, 270, 60, 75, 105}), Are({2, 4, 8, 4, 3, 3}));
}

TEST(Ies, OfAllAnglesIsAsItStands) {
  const auto file = Parse(Lamp(2, 4, "0 90\n0 90 200 360", "1 2\n1 4\n1 8\n1 2"));
  ASSERT_TRUE(file);
  EXPECT_THAT(Around(*file, {0, 90, 200, 280, 45}), Are({2, 4, 8, 5, 3}));
}

// Files that leave out the last angle, which is the first.
TEST(Ies, ThatEndsBefore360GoesOnToTheFirstAngle) {
  const auto file = Parse(Lamp(2, 3, "0 90\n0 90 270", "1 2\n1 4\n1 8"));
  ASSERT_TRUE(file);
  EXPECT_THAT(Around(*file, {0, 90, 270, 315}), Are({2, 4, 8, 5}));
}

TEST(Ies, MultipliesByItsFactors) {
  const auto intensity = [](const std::string& edition) {
    const auto file =
        Parse(edition + "TILT=NONE\n1 1000 3 2 1 1 1 0 0 0\n0.5 0.25 10\n0 180\n0\n8 8\n");
    return file ? file->profile.Intensity({0, 0, 1}) : 0;
  };
  EXPECT_EQ(intensity("IESNA:LM-63-2002\n"), 12);
  EXPECT_EQ(intensity("IESNA:LM-63-1995\n"), 12);
  EXPECT_EQ(intensity("IES:LM-63-2019\n"), 12);
  EXPECT_EQ(intensity("IESNA91\n"), 3) << "which has a factor in the place of a reserve";
  EXPECT_EQ(intensity("Anything at all, from 1986\n"), 3);
}

TEST(Ies, TakesAnyLayoutOfItsNumbers) {
  const auto file = Parse(
      "\xEF\xBB\xBFIESNA:LM-63-1995\r\n[OTHER] TILT=\xE9 is not at the start\r\n  TILT=NONE  \r\n"
      "1,1000\t1\r\n2 1\r\n1 2 0 0 0 1 1 10 0,180 0\r\n\r\n5\r\n+.7e1");
  ASSERT_TRUE(file);
  EXPECT_EQ(file->profile.Intensity({0, 0, -1}), 7);
}

// 1 at 0 degrees, 0.8 at 90; linear between, and the same beyond.
TEST(Ies, KnowsTiltedLamps) {
  const auto file = Parse(
      "IESNA91\nTILT=INCLUDE\n1\n3\n0 40 90\n1 0.9 0.8\n1 1000 1 2 1 1 2 0 0 0 1 1 10\n0 180\n0\n5 "
      "5\n");
  ASSERT_TRUE(file);
  EXPECT_FLOAT_EQ(file->TiltFactor(0), 1);
  EXPECT_FLOAT_EQ(file->TiltFactor(20), 0.95f);
  EXPECT_FLOAT_EQ(file->TiltFactor(65), 0.85f);
  EXPECT_FLOAT_EQ(file->TiltFactor(120), 0.8f);
  EXPECT_EQ(Parse(Lamp(2, 1, "0 180\n0", "1 1"))->TiltFactor(50), 1);
}

TEST(Ies, SaysWhatIsWrongAndWhere) {
  const std::string head = "IESNA91\nTILT=NONE\n";
  const std::pair<std::string, const char*> cases[] = {
      {"", "lamp.ies: error: this is no photometric file: no line begins with 'TILT='"},
      {"IESNA91\n[TEST] 1\n", "lamp.ies: error: this is no photometric file"},
      {"IESNA91\nTILT=lamp.tlt\n",
       "lamp.ies:2:6: error: 'TILT=' expects 'NONE', or 'INCLUDE' with the table in this file, "
       "found 'lamp.tlt'"},
      {"IESNA91\nTILT=INCLUDE\n4\n",
       "lamp.ies:3:1: error: the lamp's place in the luminaire is a whole number from 1 to 3, "
       "found "
       "'4'"},
      {"IESNA91\nTILT=INCLUDE\n1\n2\n0 90\n1 -1\n",
       "lamp.ies:6:3: error: a factor for a tilt angle is not negative, found '-1'"},
      {head + "1 1000\nx",
       "lamp.ies:4:1: error: the multiplier of the candela values is due, found "
       "'x'"},
      {head + "1 1000 0",
       "lamp.ies:3:8: error: the multiplier of the candela values is above 0, "
       "found '0'"},
      {head + "1 1000 1 1 1",
       "lamp.ies:3:10: error: the number of vertical angles is a whole number from 2 to 10000, "
       "found '1'"},
      {head + "1 1000 1 2.5 1", "lamp.ies:3:10: error: the number of vertical angles is a whole"},
      {head + "1 1000 1 2 99999999999999999999 1",
       "lamp.ies:3:12: error: the number of horizontal"},
      {head + "1 1000 1 10000 10000 1",
       "lamp.ies:3:16: error: 10000 times 10000 values are more than 4000000"},
      {head + "1 1000 1 2 1 2",
       "lamp.ies:3:14: error: the photometric type is 2, type B; only 1, type C, is known"},
      {head + "1 1000 1 2 1 1 2 0 0 0 0", "lamp.ies:3:24: error: the ballast factor is above 0"},
      {head + "1 1000 1 2 1 1 2 0 0 0 1 1 1\n0 80\n",
       "lamp.ies:4:3: error: vertical angles go from 0 to 90, from 90 to 180 or from 0 to 180, "
       "found "
       "0 to 80"},
      {head + "1 1000 1 3 1 1 2 0 0 0 1 1 1\n0 90 90\n",
       "lamp.ies:4:6: error: a vertical angle is at least 0.001 above the one before it, found "
       "'90' "
       "behind 90"},
      {head + "1 1000 1 2 1 1 2 0 0 0 1 1 1\n0 90\n45\n",
       "lamp.ies:5:1: error: horizontal angles go from 0 to 0, 90, 180 or 360, or from 90 to 270, "
       "found 45 to 45"},
      {head + "1 1000 1 2 1 1 2 0 0 0 1 1 1\n0 90\n0\n1 -2\n",
       "lamp.ies:6:3: error: a candela value is not negative, found '-2'"},
      {head + "1 1000 1 2 1 1 2 0 0 0 1 1 1\n0 90\n0\n1 2e12\n",
       "lamp.ies:6:3: error: a candela value is at most 1e+12 with its factors, found '2e12'"},
      {head + "1 1000 1 2 1 1 2 0 0 0 1 1 1\n0 90\n0\n1\n",
       "lamp.ies:7:1: error: the file ends where a candela value is due"},
      {head + "1 1000 1 2 1 1 2 0 0 0 1 1 1\n0 90\n0\n1 nan\n",
       "lamp.ies:6:3: error: a candela value is due, found 'nan'"},
      {std::string("IESNA91\nTILT=\0NONE\n", 19),
       "lamp.ies:2:6: error: a text file is due, found a NUL byte"},
  };
  for (const auto& [text, message] : cases) {
    EXPECT_THAT(Report(text), ElementsAre(HasSubstr(message))) << text;
  }
}

TEST(Ies, WarnsOfSurplusWords) {
  EXPECT_THAT(Report(Lamp(2, 1, "0 180\n0", "1 1\n\n7")),
              ElementsAre("lamp.ies:10:1: warning: what follows the last of the candela values is "
                          "left out: '7'"));
}

TEST(Ies, ReadsAFileOnce) {
  IesFiles known;
  Diagnostics diagnostics;
  const auto first = ReadIesFile("assets/lamps/wall_washer.ies", {}, &known, &diagnostics);
  ASSERT_TRUE(first);
  EXPECT_EQ(ReadIesFile("assets/lamps/wall_washer.ies", {}, &known, &diagnostics), first);
  EXPECT_FALSE(ReadIesFile("assets/lamps/none.ies", {}, &known, &diagnostics));
  EXPECT_FALSE(ReadIesFile("assets/lamps/none.ies", {}, &known, &diagnostics));
  EXPECT_THAT(diagnostics.Lines(), ElementsAre(HasSubstr("none.ies': no such file")));
}

}  // namespace
}  // namespace candela
