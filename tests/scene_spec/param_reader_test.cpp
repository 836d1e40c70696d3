#include "scene_spec/param_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

namespace candela {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// Parameters with one reader for them. The text has a line for each: its name, then its words.
class Reading {
 public:
  explicit Reading(const std::string& text, bool is_damaged = false) {
    params_.is_damaged = is_damaged;
    std::istringstream lines(text);
    uint32_t number = 0;
    for (std::string line; std::getline(lines, line);) {
      const SourceLocation where{std::make_shared<const std::string>("f"), ++number, 1};
      std::istringstream words(line);
      Param param;
      words >> param.name;
      param.where = where;
      for (std::string word; words >> word;) param.words.push_back({word, {where.file, number, 9}});
      params_.params.push_back(param);
    }
  }

  ParamReader* operator->() { return &reader_; }
  /// What was reported, `Finish` included.
  std::vector<std::string> Lines() {
    reader_.Finish();
    return diagnostics_.Lines();
  }

 private:
  ParamSet params_;
  SourceLocation where_{std::make_shared<const std::string>("f"), 99, 1};
  Diagnostics diagnostics_;
  ParamReader reader_{params_, "ball", where_, &diagnostics_};
};

constexpr NamedNumber kPlanets[] = {{"mars", 4}, {"venus", 2}};

TEST(ParamReader, TakesANameForANumber) {
  Reading r("a mars\nb 3");
  EXPECT_EQ(r->PositiveOrNamed("a", kPlanets, 1), 4.0f);
  EXPECT_EQ(r->PositiveOrNamed("b", kPlanets, 1), 3.0f);
  EXPECT_EQ(r->PositiveOrNamed("c", kPlanets, 1), 1.0f);
  EXPECT_THAT(r.Lines(), IsEmpty());
}

TEST(ParamReader, ListsTheNamesThatStandForNumbers) {
  Reading r("a moon\nb -1\nc");
  for (const char* name : {"a", "b", "c"}) r->PositiveOrNamed(name, kPlanets, 1);
  EXPECT_THAT(
      r.Lines(),
      ElementsAre("f:1:9: error: 'a' expects a positive number or one of 'mars' and 'venus', found "
                  "'moon'",
                  "f:2:9: error: 'b' expects a positive number or one of 'mars' and 'venus', found "
                  "'-1'",
                  "f:3:1: error: 'c' expects a positive number or one of 'mars' and 'venus', found "
                  "nothing"));
}

TEST(ParamReader, ReadsFlagsAndFractions) {
  Reading r("a true\nb false\nc 1\nd yes\ne 1.1\nf 0.5");
  EXPECT_TRUE(r->Flag("a", false));
  EXPECT_FALSE(r->Flag("b", true));
  EXPECT_TRUE(r->Flag("z", true));
  EXPECT_EQ(r->Fraction("f", 0), 0.5f);
  EXPECT_FALSE(r->Flag("c", false));
  EXPECT_FALSE(r->Flag("d", false));
  EXPECT_EQ(r->Fraction("e", 0.25f), 0.25f);
  EXPECT_THAT(r.Lines(),
              ElementsAre("f:3:9: error: 'c' expects 'true' or 'false', found '1'",
                          "f:4:9: error: 'd' expects 'true' or 'false', found 'yes'",
                          "f:5:9: error: 'e' expects a number from 0 to 1, found '1.1'"));
}

TEST(ParamReader, ReadsValuesOfEachKind) {
  Reading r("a 1.5\nb 1 2 3\nc word\nd 9223372036854775807");
  EXPECT_EQ(r->Number("a", 0), 1.5f);
  EXPECT_EQ(r->Vector("b", {}), (Vec3{1, 2, 3}));
  EXPECT_EQ(r->Word("c"), "word");
  EXPECT_EQ(r->RequiredInteger("d"), INT64_MAX);
  EXPECT_THAT(r.Lines(), IsEmpty());
}

TEST(ParamReader, DefaultsStandInForWhatIsMissing) {
  Reading r("");
  EXPECT_EQ(r->Number("a", 7), 7);
  EXPECT_EQ(r->Positive("b", 8), 8);
  EXPECT_EQ(r->Color("c", {1, 2, 3}), (Rgb{1, 2, 3}));
  EXPECT_EQ(r->Word("d"), "");
  EXPECT_FALSE(r->Has("a"));
  EXPECT_EQ(r->Where("a").line, 99u);
  EXPECT_THAT(r.Lines(), IsEmpty());
}

TEST(ParamReader, WhatIsRequiredIsReportedTogether) {
  Reading r("");
  r->RequiredNumber("a");
  r->RequiredVector("b");
  EXPECT_EQ(r->RequiredInteger("c"), std::nullopt);
  r->RequiredWord("c");
  EXPECT_THAT(r.Lines(), ElementsAre("f:99:1: error: 'ball' needs 'a', 'b' and 'c'"));
}

TEST(ParamReader, OfADamagedBlockNothingIsMissing) {
  Reading r("b 1 2", true);
  r->RequiredNumber("a");
  r->RequiredVector("b");
  EXPECT_THAT(r.Lines(), IsEmpty());
}

TEST(ParamReader, AMisspeltNameIsNotMissingToo) {
  Reading r("radus 1");
  r->RequiredPositive("radius");
  EXPECT_THAT(r.Lines(), ElementsAre("f:1:1: error: parameter 'radus' is not used by 'ball' (did "
                                     "you mean 'radius'?)"));
}

TEST(ParamReader, ANameTakenForAValueIsNotMissingToo) {
  Reading r("center direction 0 0 1");
  r->RequiredVector("center");
  r->RequiredVector("direction");
  EXPECT_THAT(r.Lines(),
              ElementsAre("f:1:9: error: 'center' expects three numbers, found 'direction'"));
}

TEST(ParamReader, UnlikeNamesGetTheListOfAll) {
  Reading r("spin 1");
  r->Number("radius", 1);
  r->Number("center", 1);
  EXPECT_THAT(r.Lines(), ElementsAre("f:1:1: error: parameter 'spin' is not used by 'ball'; "
                                     "accepted: 'radius' or 'center'"));
}

TEST(ParamReader, AWordBetweenNumbersIsFoundInItsPlace) {
  Reading r("b 1\nx 3");
  r->Vector("b", {});
  EXPECT_THAT(r.Lines(), ElementsAre("f:2:1: error: 'b' expects three numbers, found 'x'"));
}

TEST(ParamReader, CountsNumbers) {
  Reading r("a\nb 1 2\nc 1 2 3 4\nd 1 2\ne\ng 1 x");
  r->Number("a", 0);
  r->Vector("b", {});
  r->Vector("c", {});
  r->RequiredInteger("d");
  r->Word("e");
  r->Word("g");
  EXPECT_THAT(r.Lines(), ElementsAre("f:1:1: error: 'a' expects a number, found nothing",
                                     "f:2:1: error: 'b' expects three numbers, found 2 numbers",
                                     "f:3:9: error: 'c' expects three numbers, found 4 numbers",
                                     "f:4:9: error: 'd' expects a whole number, found 2 numbers",
                                     "f:5:1: error: 'e' expects a word, found nothing",
                                     "f:6:9: error: 'g' expects one word, found 'x' behind '1'"));
}

TEST(ParamReader, SaysWhatIsTooLarge) {
  Reading r("a 1e39\nb 99999999999999999999\nc -99999999999999999999\nd 1e5");
  r->Number("a", 0);
  for (const char* name : {"b", "c", "d"}) EXPECT_EQ(r->RequiredInteger(name), std::nullopt);
  EXPECT_THAT(r.Lines(),
              ElementsAre("f:1:9: error: 'a' expects a number, found '1e39', which is too large",
                          "f:2:9: error: 'b' expects a whole number, found "
                          "'99999999999999999999', which is too large",
                          "f:3:9: error: 'c' expects a whole number, found "
                          "'-99999999999999999999', which is too large",
                          "f:4:9: error: 'd' expects a whole number, found '1e5'"));
}

TEST(ParamReader, RangesAreHalfTheMeaning) {
  Reading r("a 0\nb -1\nc 180\nd 0 -0 1e-60\ne 0 1 1.5\ng 0 0 -1\nh 1e-60");
  EXPECT_EQ(r->Positive("a", 5), 5);
  EXPECT_EQ(r->NonNegative("b", 5), 5);
  r->RequiredAngle("c");
  EXPECT_NE(r->RequiredDirection("d"), Vec3());
  r->Albedo("e", {});
  r->NonNegativeColor("g", {});
  r->RequiredPositive("h");
  EXPECT_THAT(
      r.Lines(),
      ElementsAre("f:1:9: error: 'a' expects a positive number, found '0'",
                  "f:2:9: error: 'b' expects a number that is not negative, found '-1'",
                  "f:3:9: error: 'c' expects an angle above 0 and below 180 degrees, found '180'",
                  "f:4:9: error: 'd' expects a direction: three numbers, not all of them 0",
                  "f:5:9: error: 'e' expects three numbers from 0 to 1, found '1.5'",
                  "f:6:9: error: 'g' expects three numbers that are not negative, found '-1'",
                  "f:7:9: error: 'h' expects a positive number, found '1e-60'"));
}

TEST(ParamReader, OfRepeatedNamesTheLastCountsAndAllAreChecked) {
  Reading r("a 1\na x\na 3");
  EXPECT_EQ(r->Number("a", 0), 3);
  EXPECT_EQ(r->Where("a").line, 3u);
  EXPECT_THAT(r.Lines(), ElementsAre("f:2:9: error: 'a' expects a number, found 'x'"));
}

}  // namespace
}  // namespace candela
