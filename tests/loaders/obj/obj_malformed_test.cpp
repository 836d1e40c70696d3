#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "base/clock.h"
#include "tests/loaders/obj/obj_text.h"

namespace candela {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

/// Lines 1 to 3: three vertices. The text under test starts in line 4.
std::vector<std::string> Lines(const std::string& text) {
  return ReadObjText("v 0 0 0\nv 1 0 0\nv 0 1 0\n" + text).lines;
}

TEST(ObjMalformed, NumbersAreDecimalAndFinite) {
  for (const char* word :
       {"nan", "inf", "-inf", "0x10", "1,5", "1.2.3", "1e39", "1e", "--1", "x"}) {
    EXPECT_THAT(
        Lines(fmt::format("v 1 {} 3\nv 1 2 {}\nvn {} 2 3\nvt {}\nv 1 2 3 {}", word, word, word,
                          word, word)),
        ElementsAre(fmt::format("a.obj:4:5: error: 'v' expects numbers, found '{}'", word),
                    fmt::format("a.obj:5:7: error: 'v' expects numbers, found '{}'", word),
                    fmt::format("a.obj:6:4: error: 'vn' expects numbers, found '{}'", word),
                    fmt::format("a.obj:7:4: error: 'vt' expects numbers, found '{}'", word),
                    fmt::format("a.obj:8:9: error: 'v' expects numbers, found '{}'", word)));
  }
}

TEST(ObjMalformed, CoordinatesAreCounted) {
  EXPECT_THAT(Lines("v\n v 1 2\nvn 1 2 # 3\nvn 1 2 3 4\nvt\nvt 1 2 3 4"),
              ElementsAre("a.obj:4:1: error: 'v' needs at least three coordinates, found 0",
                          "a.obj:5:2: error: 'v' needs at least three coordinates, found 2",
                          "a.obj:6:1: error: 'vn' needs three coordinates, found 2",
                          "a.obj:7:1: error: 'vn' needs three coordinates, found 4",
                          "a.obj:8:1: error: 'vt' needs one to three coordinates, found 0",
                          "a.obj:9:1: error: 'vt' needs one to three coordinates, found 4"));
}

TEST(ObjMalformed, AWrongVertexDoesNotMoveTheIndicesOfOthers) {
  const ReadText read = ReadObjText("v 1\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 2 3 4\nf 4 3 -2\n");
  EXPECT_THAT(read.lines,
              ElementsAre("a.obj:1:1: error: 'v' needs at least three coordinates, found 1",
                          "a.obj:6:1: warning: a face without area is left out"));
}

TEST(ObjMalformed, FacesHaveThreeCorners) {
  EXPECT_THAT(Lines("f\nf 1\nf 1 2 \\\n# 3"),
              ElementsAre("a.obj:4:1: error: 'f' needs at least three corners, found 0",
                          "a.obj:5:1: error: 'f' needs at least three corners, found 1",
                          "a.obj:6:1: error: 'f' needs at least three corners, found 2"));
}

TEST(ObjMalformed, CornersAreWholeNumbersInOneOfFourForms) {
  for (const char* corner : {"x", "1.0", "1e0", "1/", "/1", "//1", "1//", "1/1/", "1/1/1/1",
                             "1///1", "/", "1\\1", "99999999999999999999", "1,2", "0x1", "+-1"}) {
    EXPECT_THAT(Lines(fmt::format("vt 0\nvn 0 0 1\nf 1 {} 3\n", corner)),
                ElementsAre(fmt::format("a.obj:6:5: error: 'f' expects corners like v, v/vt, v//vn "
                                        "or v/vt/vn, found '{}'",
                                        corner)));
  }
}

TEST(ObjMalformed, IndexZero) {
  EXPECT_THAT(Lines("vt 0\nvn 0 0 1\nf 0 2 3\nf 1/0 2 3\nf 1//0 2 3\nf -0 2 3"),
              ElementsAre("a.obj:6:3: error: vertex index 0 in '0': indices count from 1",
                          "a.obj:7:3: error: texture index 0 in '1/0': indices count from 1",
                          "a.obj:8:3: error: normal index 0 in '1//0': indices count from 1",
                          "a.obj:9:3: error: vertex index 0 in '-0': indices count from 1"));
}

TEST(ObjMalformed, IndicesBackwardsStayInTheirList) {
  EXPECT_THAT(
      Lines("vn 0 0 1\nf 1 2 -4\nf 1//-2 2 3\nf 1/-1 2 3\nf 1 2 -9223372036854775808\nv 1 1 1\n"),
      ElementsAre("a.obj:5:7: error: vertex index -4 in '-4' is out of range: there are 3 vertices "
                  "before it",
                  "a.obj:6:3: error: normal index -2 in '1//-2' is out of range: there is 1 normal "
                  "before it",
                  "a.obj:7:3: error: texture index -1 in '1/-1' is out of range: there are 0 "
                  "texture vertices before it",
                  "a.obj:8:7: error: vertex index -9223372036854775808 in '-9223372036854775808' "
                  "is out of range: there are 3 vertices before it"));
}

TEST(ObjMalformed, IndicesForwardsStayInTheFile) {
  // 4294967297 would be 1 in 32 bits.
  EXPECT_THAT(
      Lines("f 1 2 5\nf 1 2 4294967297\nf 1 2 9223372036854775807\nf 1//1 2 3\nv 1 1 1\nf 1 2 4\n"),
      ElementsAre(
          "a.obj:4:7: error: vertex index 5 in '5' is out of range: there are 4 vertices",
          "a.obj:5:7: error: vertex index 4294967297 in '4294967297' is out of range: there "
          "are 4 vertices",
          "a.obj:6:7: error: vertex index 9223372036854775807 in '9223372036854775807' is "
          "out of range: there are 4 vertices",
          "a.obj:7:3: error: normal index 1 in '1//1' is out of range: there are 0 normals"));
}

TEST(ObjMalformed, AllCornersOfAFaceAreLookedAt) {
  EXPECT_THAT(Lines("f 1 a 0 b 3"), SizeIs(3));
}

TEST(ObjMalformed, NulByte) {
  using namespace std::string_literals;
  EXPECT_THAT(Lines("# a\0b"s),
              ElementsAre("a.obj:4:4: error: a text file is due, found a NUL byte"));
  EXPECT_THAT(ReadObjText("\0"s).lines,
              ElementsAre("a.obj:1:1: error: a text file is due, found a NUL byte"));
}

TEST(ObjMalformed, UnknownKeywordsAreToldOnceEach) {
  EXPECT_THAT(
      Lines("usemat a\nusemat b\nV 1 2 3\nf 1 2 3"),
      ElementsAre(
          "a.obj:4:1: warning: unknown keyword 'usemat' (did you mean 'usemap'?); "
          "such lines are left out",
          "a.obj:6:1: warning: unknown keyword 'V' (did you mean 'v'?); such lines are left out"));
}

TEST(ObjMalformed, GeometryThatIsNotReadIsToldOncePerKeyword) {
  EXPECT_THAT(Lines("p 1\nl 1 2\np 2\nsurf 0 1 0 1\nf 1 2 3"),
              ElementsAre("a.obj:4:1: warning: 'p': points are left out",
                          "a.obj:5:1: warning: 'l': lines are left out",
                          "a.obj:7:1: warning: 'surf': free-form surfaces are left out"));
}

TEST(ObjMalformed, FacesWithoutAreaAreCountedInOneWarning) {
  const ReadText one = ReadObjText("v 0 0 0\nv 1 1 1\nv 3 3 3\nv 0 1 0\nf 1 2 3\nf 1 2 4");
  EXPECT_THAT(one.lines, ElementsAre("a.obj:5:1: warning: a face without area is left out"));
  EXPECT_THAT(one.mesh.triangles, ElementsAre(MeshSpec::Corners{0, 1, 3}));
  EXPECT_THAT(Lines("f 1 2 3\nf 1 1 2\n f 1 2 1 2\nf 3 3 3 3 3"),
              ElementsAre("a.obj:5:1: warning: 3 faces without area are left out, this one first"));
}

TEST(ObjMalformed, TinyTrianglesHaveArea) {
  const ReadText read = ReadObjText("v 0 0 0\nv 1e-30 0 0\nv 0 1e-30 0\nf 1 2 3");
  EXPECT_THAT(read.lines, IsEmpty());
  EXPECT_THAT(read.mesh.triangles, SizeIs(1));
}

TEST(ObjMalformed, ZeroNormalsAreNoNormals) {
  constexpr uint32_t kNone = MeshSpec::kNoNormal;
  const ReadText one =
      ReadObjText("v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nvn 0 -0 0\nf 1//1 2//2 3//1");
  EXPECT_THAT(
      one.lines,
      ElementsAre("a.obj:5:1: warning: a zero normal: the geometric normal is used instead"));
  EXPECT_THAT(one.mesh.normal_corners, ElementsAre(MeshSpec::Corners{0, kNone, 0}));

  const ReadText all =
      ReadObjText("v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 0\nvn 0 0 0\nvn 0 0 0\nf 1//2 2//3 3");
  EXPECT_THAT(all.lines, ElementsAre("a.obj:4:1: warning: 3 zero normals, this one first: the "
                                     "geometric normal is used instead"));
  EXPECT_THAT(all.mesh.normal_corners, IsEmpty());
}

TEST(ObjMalformed, ReadingStopsWhenAllErrorsThatAreShownAreFound) {
  std::string text;
  for (int i = 0; i < 1000; ++i) text += "f a b\n";
  const std::vector<std::string> lines = Lines(text);
  ASSERT_THAT(lines, SizeIs(Diagnostics::kMostPerFile));
  EXPECT_THAT(lines.back(), testing::StartsWith("a.obj:13:5: error: "));
}

TEST(ObjMalformed, TruncationAnywhereIsHandled) {
  const std::string text =
      "\xEF\xBB\xBFmtllib a.mtl\r\no x\nv 0 0 0\nv 1 0 0 \\\r\n\nv 1 1 0\nv 0 1 0\nvt 0 0\nvn 0 0 "
      "1\n"
      "usemtl red\nf 1/1/1 2/1/1 3/1/1 -1/-1/-1 # end\nf 1//1 3//1 6//1\np 1\nv 5 5 5\nv 6 6 7";
  for (size_t size = 0; size <= text.size(); ++size) {
    // A copy of the exact size, so that the address sanitizer sees a read behind the end.
    const std::vector<char> cut(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(size));
    const ReadText read = ReadObjText({cut.data(), cut.size()});
    EXPECT_LE(read.lines.size(), 3u) << size;
  }
  EXPECT_THAT(ReadObjText(text).mesh.triangles, SizeIs(3));
}

// Each of these takes hours when something in the reader is quadratic.
TEST(ObjMalformed, HostileTextsTakeLinearTime) {
  const auto repeat = [](const std::string& text, int times) {
    std::string all;
    for (int i = 0; i < times; ++i) all += text;
    return all;
  };
  constexpr int kMany = 300'000;
  std::string keywords, materials;
  for (int i = 0; i < kMany; ++i) {
    keywords += fmt::format("w{}\n", i);
    materials += fmt::format("usemtl m{}\ng g{}\nmtllib f{}\n", i, i, i);
  }
  for (const std::string& text :
       {keywords, materials, repeat("x", 10 * kMany), repeat("\\\n", kMany),
        repeat("#", 10 * kMany), repeat("f 1 2 5\n", kMany), repeat("f 1 2 2\n", kMany),
        "v " + repeat("1 ", 10 * kMany), "g " + repeat("a \\\n", kMany),
        "f " + repeat("1 2 3 ", kMany), "v .5 .1 0\nf " + repeat("1 2 4 3 ", kMany),
        "f " + repeat("1 ", kMany)}) {
    const Stopwatch watch;
    Lines(text);
    EXPECT_LT(watch.Seconds(), 60) << text.substr(0, 30);
  }
}

}  // namespace
}  // namespace candela
