// The commands of candela that render nothing, run as a user does.

#include "tests/apps/programs.h"

namespace candela::testing_support {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

using CandelaTest = ProgramTest;

TEST_F(CandelaTest, ShowsItsCommands) {
  for (const std::vector<std::string>& ask :
       {std::vector<std::string>{"--help"}, {"-h"}, {"help"}, {"help", "--help"}}) {
    const ProgramEnd end = Candela(ask);
    EXPECT_EQ(end.status, 0);
    EXPECT_EQ(end.err, "");
    for (const char* command : {"render", "check", "info", "compare", "contact-sheet", "help"}) {
      EXPECT_THAT(end.out, HasSubstr(std::string("\n  ") + command + " "));
    }
  }
  EXPECT_THAT(Candela({"--version"}).out, testing::MatchesRegex("Candela [0-9.]+\n"));
}

TEST_F(CandelaTest, ExplainsEachCommand) {
  for (const char* command : {"render", "check", "info", "compare", "contact-sheet"}) {
    const ProgramEnd asked = Candela({command, "--help"});
    EXPECT_EQ(asked.status, 0);
    EXPECT_THAT(asked.out, testing::StartsWith(std::string("Usage: candela ") + command + " "));
    EXPECT_THAT(asked.out, HasSubstr("\nExamples:\n"));
    EXPECT_EQ(Candela({"help", command}).out, asked.out);
    EXPECT_EQ(Candela({command, "--version"}).out, Candela({"--version"}).out);
  }
}

TEST_F(CandelaTest, HelpOfRenderNamesEveryOption) {
  const std::string help = Candela({"help", "render"}).out;
  for (const char* option : {"\n  SCENE ",
                             "\n  -o, --output FILE ",
                             "\n  --normals FILE ",
                             "\n  --depth MIN MAX FILE ",
                             "\n  --png-bits BITS ",
                             "\n  --size W H ",
                             "\n  --stretch ",
                             "\n  --crop X0 Y0 X1 Y1 ",
                             "\n  --pixel-grid GRID ",
                             "\n  --integrator NAME ",
                             "\n  --bounces N ",
                             "\n  --shadows ",
                             "\n  --samples N ",
                             "\n  --filter NAME ",
                             "\n  --jitter ",
                             "\n  --seed N ",
                             "\n  --threads N ",
                             "\n  --quiet ",
                             "\n  --stats ",
                             "\n  --stats-json FILE ",
                             "\n  --pixel X Y "}) {
    EXPECT_THAT(help, HasSubstr(option));
  }
}

TEST_F(CandelaTest, SuggestsTheCommandThatWasProbablyMeant) {
  ExpectRefusal(Candela({}), 2, "candela: error: a command is missing");
  ExpectRefusal(Candela({"rendre"}), 2,
                "candela: error: unknown command 'rendre' (did you mean 'render'?)");
  ExpectRefusal(Candela({"help", "chekc"}), 2,
                "candela: error: unknown command 'chekc' (did you mean 'check'?)");
  ExpectRefusal(Candela({"help", "render", "now"}), 2, "candela: error: unexpected argument 'now'");
  ExpectRefusal(Candela({"--xyz"}), 2, "candela: error: unknown command '--xyz'");
}

TEST_F(CandelaTest, CheckSumsUpAGoodScene) {
  const ProgramEnd end = Candela({"check", "scene.txt"});
  EXPECT_EQ(end.status, 0);
  EXPECT_EQ(end.out, "scene.txt: ok, 2 objects, 1 light, 2 materials\n");
  EXPECT_EQ(end.err, "");
  EXPECT_THAT(folder_.Names(), ElementsAre("scene.txt"));
}

TEST_F(CandelaTest, CheckCountsWarnings) {
  Put(folder_ / "odd.txt",
      "Camera { center 0 0 5 direction 0 0 -1 up 0 1 0 fov 40 }\n"
      "Scene { Component<Object> { type triangle vertex0 0 0 0 vertex1 1 0 0 vertex2 0 1 0 } }\n");
  const ProgramEnd end = Candela({"check", "odd.txt"});
  EXPECT_EQ(end.status, 0);
  EXPECT_EQ(end.out, "odd.txt: ok, 1 object, 1 triangle, 0 lights, 0 materials, 1 warning\n");
  EXPECT_THAT(end.err, testing::StartsWith("odd.txt:2:"));
  EXPECT_THAT(end.err, HasSubstr(": warning: "));
}

TEST_F(CandelaTest, CheckReportsWhatIsWrongAndSumsUpNothing) {
  Put(folder_ / "broken.txt", "Scene { Nod { } }\nScene { Component<Lihgt> { } }\n");
  const ProgramEnd end = Candela({"check", "broken.txt"});
  EXPECT_EQ(end.status, 1);
  EXPECT_EQ(end.out, "");
  EXPECT_THAT(end.err, HasSubstr("broken.txt:1:9: error: "));
  ExpectRefusal(Candela({"check", folder_.path().string()}), 1,
                folder_.path().string() + ": error: is a folder, not a file");
  ExpectRefusal(Candela({"check"}), 2, "candela check: error: SCENE is missing");
  ExpectRefusal(Candela({"check", "scene.txt", "more.txt"}), 2,
                "candela check: error: unexpected argument 'more.txt'");
}

// The files occupy no space on the disk.
TEST_F(CandelaTest, WhatDoesNotFitIntoMemoryHasAStatusOfItsOwn) {
  const std::string kCamera = "Camera { center 0 0 5 direction 0 0 -1 up 0 1 0 fov 40 } ";
  std::filesystem::create_directory(folder_ / "sky");
  for (const char* huge : {"huge.txt", "huge.obj", "sky/left.png"}) {
    Put(folder_ / huge, "");
    std::filesystem::resize_file(folder_ / huge, uintmax_t{1} << 43);
  }
  Put(folder_ / "mesh.txt", kCamera +
                                "Materials { Material { } } Scene { Component<Material> { "
                                "index 0 } Component<Object> { type mesh obj_file huge.obj } }");
  Put(folder_ / "sky.txt", kCamera + "Background { cube_map sky } Scene { }");
  for (const char* scene : {"huge.txt", "mesh.txt", "sky.txt"}) {
    const ProgramEnd end = Candela({"check", scene});
    EXPECT_EQ(end.status, 4) << scene;
    EXPECT_THAT(end.err, HasSubstr("does not fit into memory\n"));
  }
}

TEST_F(CandelaTest, InfoShowsWhatASceneHolds) {
  Put(folder_ / "mesh.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 3\nf 2 4 3\n");
  Put(folder_ / "mesh.txt",
      "Camera { center 0 0 5 direction 0 0 -1 up 0 1 0 fov 40 }\n"
      "Background { color 0.25 0.5 1 ambient_light 0 0 0.125 }\n"
      "Materials { Material { diffuse 1 1 1 } }\n"
      "Scene { Component<Material> { index 0 } Component<Object> { type mesh obj_file mesh.obj }\n"
      "  Node { Component<Light> { type point color 1 1 1 } } }\n");
  const ProgramEnd end = Candela({"info", "mesh.txt"});
  EXPECT_EQ(end.status, 0);
  EXPECT_EQ(end.err, "");
  EXPECT_THAT(end.out, testing::StartsWith("scene       mesh.txt\n"
                                           "objects     1 (1 mesh)\n"
                                           "triangles   2\n"
                                           "mesh        mesh.obj: 2 triangles, 4 positions\n"
                                           "lights      1 (1 point)\n"
                                           "materials   1\n"
                                           "background  0.25 0.5 1\n"
                                           "ambient     0 0 0.125\n"
                                           "bounds      "));
  EXPECT_THAT(end.out, HasSubstr("\ncamera      at 0 0 5, direction 0 0 -1, up 0 1 0, 40 degrees\n"
                                 "render      integrator whitted, "));
  EXPECT_THAT(end.out, HasSubstr("\nfilm        tonemap none, size 800 800, "));
  EXPECT_THAT(end.out, HasSubstr("\ntree        "));
  EXPECT_THAT(end.out, HasSubstr("\nmemory      "));
}

// One light is beyond single precision and left out.
TEST_F(CandelaTest, InfoCountsTheLightsThatShine) {
  Put(folder_ / "far.txt",
      "Camera { center 0 0 5 direction 0 0 -1 up 0 1 0 fov 40 } Scene {\n"
      "  Node { Component<Light> { type point color 1 1 1 } }\n"
      "  Node { Transform { scale 1e30 1e30 1e30 translate 1e30 0 0 }\n"
      "         Component<Light> { type point color 1 1 1 } } }\n");
  const ProgramEnd end = Candela({"info", "far.txt"});
  EXPECT_EQ(end.status, 0) << end.err;
  EXPECT_THAT(end.err, HasSubstr("the light is left out"));
  EXPECT_THAT(end.out, HasSubstr("\nlights      1 (1 point)\n"));
  EXPECT_THAT(end.out, HasSubstr(" MiB, textures and background included\n"));
}

// The floor alone has no bounds.
TEST_F(CandelaTest, InfoSaysWhenNothingIsBounded) {
  Put(folder_ / "floor.txt",
      "Camera { center 0 0 5 direction 0 0 -1 up 0 1 0 fov 40 } Materials { Material { } } Scene "
      "{\n"
      "Component<Material> { index 0 } Component<Object> { type plane normal 0 1 0 offset 0 } }");
  EXPECT_THAT(Candela({"info", "floor.txt"}).out,
              HasSubstr("\nbounds      none: every object is unbounded\n"));
}

TEST_F(CandelaTest, ContactSheetPutsPicturesSideBySide) {
  EXPECT_EQ(Candela({"render", "scene.txt", "-o", "a.png", "--size", "40", "30"}).status, 0);
  EXPECT_EQ(Candela({"render", "scene.txt", "-o", "b.exr", "--size", "10", "10"}).status, 0);
  const ProgramEnd end = Candela({"contact-sheet", "sheet.png", "a.png", "b.exr", "a.png",
                                  "--columns", "2", "--cell", "20", "20", "--margin", "3"});
  EXPECT_EQ(end.status, 0) << end.err;
  EXPECT_EQ(Picture("sheet.png").Width(), 3 + 2 * 23);
  EXPECT_EQ(Picture("sheet.png").Height(), 3 + 2 * 23);
}

TEST_F(CandelaTest, ContactSheetRefusesWhatCannotBeOne) {
  const auto refused = [&](std::vector<std::string> arguments, int status,
                           const std::string& message) {
    arguments.insert(arguments.begin(), "contact-sheet");
    ExpectRefusal(Candela(arguments), status, "candela contact-sheet: error: " + message);
  };
  Put(folder_ / "a.png", "nothing like it");
  refused({"sheet.png"}, 2, "IN is missing");
  refused({"a.png", "a.png"}, 2, "'a.png' is one of the pictures, which would be overwritten");
  refused({"sheet.txt", "a.png"}, 2,
          "'sheet.txt': the name of a picture has to end in .png, .jpg, .exr, .hdr or .pfm");
  refused({"sheet.png", "missing.png"}, 1, "'missing.png': no such file");
  EXPECT_EQ(Candela({"contact-sheet", "sheet.png", "a.png"}).status, 1);
  EXPECT_EQ(Bytes("a.png"), "nothing like it");
  std::vector<std::string> many = {"contact-sheet", "s.png", "--cell", "16384", "16384"};
  many.resize(200, "missing.png");
  EXPECT_EQ(Candela(many).status, 4);
}

TEST_F(CandelaTest, AResultThatDoesNotArriveIsAnError) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "there is no /dev/full";
  const ProgramEnd end = RunProgram(
      "/bin/sh", {"-c", std::string(CANDELA_PROGRAM) + " check scene.txt >/dev/full"}, setup_);
  EXPECT_EQ(end.status, 3);
  EXPECT_THAT(end.err, testing::StartsWith("candela check: error: standard output cannot be "
                                           "written: "));
}

}  // namespace
}  // namespace candela::testing_support
