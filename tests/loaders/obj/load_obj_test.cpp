#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "loaders/obj/obj_reader.h"
#include "tests/support/temp_folder.h"

namespace candela {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing_support::Put;
using testing_support::TempFolder;

constexpr char kTriangle[] = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

/// Files in a folder of their own, and what reading one of them gives.
class LoadObjTest : public testing::Test {
 protected:
  /// Messages without the folder's name.
  std::vector<std::string> Load(const std::string& name) {
    Diagnostics diagnostics;
    const SourceLocation asked{std::make_shared<const std::string>("scene.txt"), 7, 9};
    mesh_ = LoadObj(folder_ / name, asked, &diagnostics);
    const std::string prefix = folder_.path().string() + "/";
    std::vector<std::string> lines = diagnostics.Lines();
    for (std::string& line : lines) {
      const size_t at = line.find(prefix);
      if (at != std::string::npos) line.erase(at, prefix.size());
    }
    return lines;
  }

  /// The same for a file with a triangle and `more`.
  std::vector<std::string> LoadWith(const std::string& more) {
    Put(folder_ / "a.obj", kTriangle + more);
    return Load("a.obj");
  }

  TempFolder folder_;
  std::shared_ptr<const MeshSpec> mesh_;
};

TEST_F(LoadObjTest, GivesTheMesh) {
  EXPECT_THAT(LoadWith(""), IsEmpty());
  ASSERT_TRUE(mesh_);
  EXPECT_THAT(mesh_->triangles, ElementsAre(MeshSpec::Corners{0, 1, 2}));
}

TEST_F(LoadObjTest, WhatCannotBeReadIsReportedWhereItIsAskedFor) {
  EXPECT_THAT(Load("none.obj"), ElementsAre("scene.txt:7:9: error: mesh 'none.obj': no such file"));
  EXPECT_FALSE(mesh_);
  std::filesystem::create_directory(folder_ / "d.obj");
  EXPECT_THAT(Load("d.obj"),
              ElementsAre("scene.txt:7:9: error: mesh 'd.obj': is a folder, not a file"));
  EXPECT_FALSE(mesh_);
}

TEST_F(LoadObjTest, AFileWithErrorsIsNoMesh) {
  EXPECT_THAT(LoadWith("f 1 2 9\n"),
              ElementsAre("a.obj:5:7: error: vertex index 9 in '9' is out of range: there are 3 "
                          "vertices"));
  EXPECT_FALSE(mesh_);
  EXPECT_THAT(LoadWith(std::string("\0", 1)),
              ElementsAre("a.obj:5:1: error: a text file is due, found a NUL byte"));
  EXPECT_FALSE(mesh_);
}

TEST_F(LoadObjTest, AFileWithoutFacesIsNoMesh) {
  Put(folder_ / "a.obj", "v 0 0 0\n");
  EXPECT_THAT(Load("a.obj"), ElementsAre("a.obj: error: the mesh has no faces"));
  EXPECT_FALSE(mesh_);
  Put(folder_ / "a.obj", "");
  EXPECT_THAT(Load("a.obj"), ElementsAre("a.obj: error: the mesh has no faces"));
  EXPECT_FALSE(mesh_);
}

TEST_F(LoadObjTest, AMeshWhoseFacesAreAllLeftOutIsEmpty) {
  Put(folder_ / "a.obj", "v 0 0 0\nf 1 1 1\n");
  EXPECT_THAT(Load("a.obj"), ElementsAre("a.obj:2:1: warning: a face without area is left out"));
  ASSERT_TRUE(mesh_);
  EXPECT_THAT(mesh_->triangles, IsEmpty());
}

TEST_F(LoadObjTest, MaterialsThatAreThereAreSilent) {
  Put(folder_ / "m.mtl",
      "# colours\r\nnewmtl red\r\nKd 1 0 0\r\n newmtl dark blue #2\r\nnewmtl x#1");
  std::filesystem::create_directory(folder_ / "sub");
  Put(folder_ / "sub/two words.mtl", "newmtl y\n");
  EXPECT_THAT(LoadWith("mtllib m.mtl\nmtllib sub/two words.mtl # c\nusemtl red\nusemtl dark blue\n"
                       "usemtl x#1\nusemtl y\nusemtl\n"),
              IsEmpty());
  EXPECT_TRUE(mesh_);
  EXPECT_THAT(LoadWith("mtllib m.mtl\n"), IsEmpty()) << "not used";
}

TEST_F(LoadObjTest, MissingMtlFilesAreWarnings) {
  EXPECT_THAT(LoadWith("mtllib  one.mtl two.mtl\nmtllib one.mtl\nusemtl red\n"),
              ElementsAre("a.obj:5:9: warning: MTL file 'one.mtl': no such file",
                          "a.obj:5:17: warning: MTL file 'two.mtl': no such file"));
  EXPECT_TRUE(mesh_);
}

TEST_F(LoadObjTest, MissingMaterialNamesAreWarnings) {
  Put(folder_ / "m.mtl", "newmtl red\n");
  EXPECT_THAT(LoadWith("mtllib m.mtl\nusemtl zebra\nusemtl blue\nusemtl zebra\n"),
              ElementsAre("a.obj:6:8: warning: no MTL file has a material 'zebra'",
                          "a.obj:7:8: warning: no MTL file has a material 'blue'"));
  EXPECT_TRUE(mesh_);
  EXPECT_THAT(LoadWith("usemtl red\n"),
              ElementsAre("a.obj:5:8: warning: no MTL file has a material 'red'"));
}

TEST_F(LoadObjTest, MtlFilesStayInTheFolderOfTheMesh) {
  std::filesystem::create_symlink("/dev/zero", folder_ / "zero.mtl");
  std::filesystem::create_directory(folder_ / "sub");
  EXPECT_THAT(
      LoadWith("mtllib /etc/passwd\nmtllib ../m.mtl\nmtllib sub/../../m.mtl\nmtllib zero.mtl\n"
               "mtllib sub\n"),
      ElementsAre(
          "a.obj:5:8: warning: MTL file '/etc/passwd': only files in the folder of the mesh "
          "are read",
          "a.obj:6:8: warning: MTL file '../m.mtl': only files in the folder of the mesh are "
          "read",
          "a.obj:7:8: warning: MTL file 'sub/../../m.mtl': only files in the folder of the "
          "mesh are read",
          "a.obj:8:8: warning: MTL file 'zero.mtl': is a device, not a file",
          "a.obj:9:8: warning: MTL file 'sub': is a folder, not a file"));
  EXPECT_TRUE(mesh_);
}

TEST_F(LoadObjTest, OnlySoManyMtlFilesAreRead) {
  std::string more;
  for (int i = 0; i < 70; ++i) {
    Put(folder_ / fmt::format("{}.mtl", i), "newmtl a\n");
    more += fmt::format("mtllib {}.mtl\n", i);
  }
  EXPECT_THAT(LoadWith(more + "usemtl b\n"),
              ElementsAre("a.obj:69:8: warning: more than 64 MTL files: the others are not read"));
}

TEST_F(LoadObjTest, NulByteInAnMtlFileIsAnError) {
  Put(folder_ / "m.mtl", std::string("newmtl a\n\0", 10));
  EXPECT_THAT(LoadWith("mtllib m.mtl\nusemtl b\n"),
              ElementsAre("m.mtl:2:1: error: a text file is due, found a NUL byte"));
  EXPECT_FALSE(mesh_);
}

}  // namespace
}  // namespace candela
