#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "tests/loaders/obj/obj_text.h"

namespace candela {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using Corners = MeshSpec::Corners;

constexpr uint32_t kNone = MeshSpec::kNoNormal;

constexpr char kSquare[] = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

/// The triangles of a text that must be without fault.
std::vector<Corners> Triangles(const std::string& text) {
  const ReadText read = ReadObjText(text);
  EXPECT_THAT(read.lines, IsEmpty()) << text;
  return read.mesh.triangles;
}

TEST(ObjLegal, PositionsAreTakenAsWritten) {
  const ReadText read = ReadObjText("v 1 -2.5 +.5e1\nv 1e-400 2. 3\nv 0 0 1\nf 1 2 3\n");
  EXPECT_THAT(read.lines, IsEmpty());
  EXPECT_THAT(read.mesh.positions, ElementsAre(Vec3{1, -2.5f, 5}, Vec3{0, 2, 3}, Vec3{0, 0, 1}));
  EXPECT_THAT(read.mesh.triangles, ElementsAre(Corners{0, 1, 2}));
  EXPECT_THAT(read.mesh.normals, IsEmpty());
  EXPECT_THAT(read.mesh.normal_corners, IsEmpty());
}

TEST(ObjLegal, WeightsAndColoursHaveNoEffect) {
  const ReadText read = ReadObjText("v 0 0 0 1\nv 1 0 0 .5 .5 .5\nv 0 1 0 1 1 1 1\nf 1 2 3\n");
  EXPECT_THAT(read.lines, IsEmpty());
  EXPECT_THAT(read.mesh.positions, ElementsAre(Vec3{0, 0, 0}, Vec3{1, 0, 0}, Vec3{0, 1, 0}));
}

TEST(ObjLegal, TextureCoordinatesHaveIndicesOfTheirOwn) {
  const ReadText read = ReadObjText(std::string(kSquare) +
                                    "vt 0 .5\nvt 1\nvt 1 1 9\nf 1 2 3\nf 1/1 2/-2 3/3\nf 1 3 4\n");
  EXPECT_THAT(read.lines, IsEmpty());
  EXPECT_THAT(read.mesh.uvs, ElementsAre(Vec2{0, 0.5f}, Vec2{1, 0}, Vec2{1, 1}));
  constexpr uint32_t kNoUv = MeshSpec::kNoUv;
  EXPECT_THAT(read.mesh.uv_corners, ElementsAre(Corners{kNoUv, kNoUv, kNoUv}, Corners{0, 1, 2},
                                                Corners{kNoUv, kNoUv, kNoUv}));
}

TEST(ObjLegal, TextureCoordinatesThatNoCornerNamesAreDropped) {
  const ReadText read = ReadObjText(std::string(kSquare) + "vt 0 0\nf 1 2 3\n");
  EXPECT_THAT(read.mesh.uvs, IsEmpty());
  EXPECT_THAT(read.mesh.uv_corners, IsEmpty());
}

TEST(ObjLegal, ConvexPolygonsAreFansFromTheFirstCorner) {
  EXPECT_THAT(Triangles(std::string(kSquare) + "f 2 3 4 1"),
              ElementsAre(Corners{1, 2, 3}, Corners{1, 3, 0}));
}

TEST(ObjLegal, NegativeIndicesCountBackFromTheLine) {
  EXPECT_THAT(Triangles("v 9 9 9\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\nv 5 5 5\nf -4 -3 -2\n"),
              ElementsAre(Corners{1, 2, 3}, Corners{1, 2, 3}));
}

TEST(ObjLegal, FacesMayNameVerticesThatComeLater) {
  EXPECT_THAT(Triangles("v 0 0 0\nf 1 2 3\nf -1 2 3\nv 1 0 0\nv 0 1 0\nf 3 1 2\n"),
              ElementsAre(Corners{2, 0, 1}, Corners{0, 1, 2}, Corners{0, 1, 2}));
}

TEST(ObjLegal, SeparateNormalIndicesCount) {
  const ReadText read = ReadObjText(
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0\nvt 0 0\nvt 0 0 0\nvn 0 0 1\nvn 0 0 2\n"
      "f 1 2 3\nf 1//2 2//1 3//-1\nf 1/1/1 2/2/1 3/-1/2\nf 1/1 2/2 3//1\n");
  EXPECT_THAT(read.lines, IsEmpty());
  EXPECT_THAT(read.mesh.normals, ElementsAre(Vec3{0, 0, 1}, Vec3{0, 0, 2}));
  EXPECT_THAT(read.mesh.normal_corners, ElementsAre(Corners{kNone, kNone, kNone}, Corners{1, 0, 1},
                                                    Corners{0, 0, 1}, Corners{kNone, kNone, 0}));
}

TEST(ObjLegal, WithAsManyNormalsAsPositionsTheFirstIndexSelectsBoth) {
  const ReadText read =
      ReadObjText("vn 1 0 0\nvn 0 1 0\nvn 0 0 1\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 3/ 1 2\n");
  EXPECT_THAT(read.lines, testing::SizeIs(1));
  EXPECT_THAT(read.mesh.normal_corners, ElementsAre(Corners{0, 1, 2}));
  EXPECT_THAT(ReadObjText("vn 1 0 0\nvn 0 1 0\nvn 0 0 1\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1//3 2 3\n")
                  .mesh.normal_corners,
              ElementsAre(Corners{2, 1, 2}));
}

TEST(ObjLegal, NormalsThatNoCornerUsesAreDropped) {
  const ReadText read = ReadObjText("vn 1 0 0\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  EXPECT_THAT(read.lines, IsEmpty());
  EXPECT_THAT(read.mesh.normals, IsEmpty());
  EXPECT_THAT(read.mesh.normal_corners, IsEmpty());
}

TEST(ObjLegal, LayoutHasNoEffect) {
  const auto triangle = ElementsAre(Corners{0, 1, 2});
  const std::string v = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  EXPECT_THAT(Triangles(v + "f 1 2 3"), triangle) << "no newline at the end";
  EXPECT_THAT(Triangles("\xEF\xBB\xBFv 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\nf 1 2 3\r\n"), triangle);
  EXPECT_THAT(Triangles(v + "f 1 2 \\\n3\n"), triangle) << "continued";
  EXPECT_THAT(Triangles(v + "f 1\\\r\n 2 \\\r\n3\r\n"), triangle) << "continued, CRLF";
  EXPECT_THAT(Triangles(v + "f 1 2 3 \\"), triangle) << "continued into nothing";
  EXPECT_THAT(Triangles(v + "f 1 2 3 \\\n\n\nf 1 2 3 \\\n# c"),
              ElementsAre(Corners{0, 1, 2}, Corners{0, 1, 2}));
  EXPECT_THAT(Triangles("# c\n #c\n" + v + "f 1 2 3# c\n\t f\t1 2 3 #f 1 2\n"),
              ElementsAre(Corners{0, 1, 2}, Corners{0, 1, 2}));
  EXPECT_THAT(Triangles("# C:\\models\\\n" + v + "f 1 2 3"), triangle)
      << "a comment is not continued";
}

TEST(ObjLegal, KnownKeywordsWithoutEffectAreSilent) {
  EXPECT_THAT(Triangles("mtllib a.mtl\no a\ng b c\ns off\nusemtl x y#1\nvp 1 2\nlod 3\n"
                        "g left \\\n f 1 2\n"
                        "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3"),
              ElementsAre(Corners{0, 1, 2}));
}

TEST(ObjLegal, AnEmptyTextIsAnEmptyMesh) {
  EXPECT_THAT(Triangles(""), IsEmpty());
  EXPECT_THAT(Triangles("\n\n \\"), IsEmpty());
}

}  // namespace
}  // namespace candela
