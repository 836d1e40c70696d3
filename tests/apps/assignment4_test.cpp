// The course's program, run as a user does.

#include <fmt/format.h>

#include "tests/apps/programs.h"

namespace candela::testing_support {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

using Assignment4Test = ProgramTest;

TEST_F(Assignment4Test, WritesThePictureAndNothingElse) {
  const ProgramEnd end = Assignment4({"-input", "scene.txt", "-output", "out.png"});
  EXPECT_EQ(end.status, 0);
  EXPECT_EQ(end.out, "");
  EXPECT_EQ(end.err, "");
  EXPECT_THAT(folder_.Names(), ElementsAre("out.png", "scene.txt"));
  EXPECT_EQ(Picture("out.png").Width(), 200);
  EXPECT_EQ(Picture("out.png").Height(), 200);
}

TEST_F(Assignment4Test, TakesEveryFlagOfTheCourse) {
  const ProgramEnd end = Assignment4({"-input", "scene.txt", "-size", "40", "30", "-bounces", "4",
                                      "-shadows", "-jitter", "-filter", "-output", "o.png",
                                      "-normals", "n.png", "-depth", "5", "12.5", "d.png"});
  EXPECT_EQ(end.status, 0) << end.err;
  for (const char* name : {"o.png", "n.png", "d.png"}) {
    EXPECT_EQ(Picture(name).Width(), 40) << name;
    EXPECT_EQ(Picture(name).Height(), 30) << name;
  }
}

// Each flag shows in the picture, and the two of samples in different ways.
TEST_F(Assignment4Test, EveryFlagMakesADifference) {
  const auto picture = [&](const std::string& name, std::vector<std::string> flags) {
    flags.insert(flags.end(),
                 {"-input", "scene.txt", "-size", "60", "40", "-output", name + ".png"});
    const ProgramEnd end = Assignment4(flags);
    EXPECT_EQ(end.status, 0) << end.err;
    return Fingerprint(name + ".png");
  };
  const std::vector<size_t> pictures = {picture("plain", {}),
                                        picture("bounces", {"-bounces", "1"}),
                                        picture("shadows", {"-shadows"}),
                                        picture("jitter", {"-jitter"}),
                                        picture("filter", {"-filter"}),
                                        picture("stretch", {"-stretch"})};
  for (size_t i = 0; i < pictures.size(); ++i) {
    for (size_t j = 0; j < i; ++j) EXPECT_NE(pictures[i], pictures[j]) << i << " and " << j;
  }
  EXPECT_EQ(picture("both", {"-jitter", "-filter"}), pictures[4]);
  EXPECT_EQ(picture("again", {}), pictures[0]);
}

TEST_F(Assignment4Test, MapsUseTheMiddleRayWhateverTheSamples) {
  const std::vector<std::string> common = {"-input", "scene.txt", "-size", "20", "20"};
  const auto run = [&](std::vector<std::string> flags) {
    flags.insert(flags.end(), common.begin(), common.end());
    EXPECT_EQ(Assignment4(flags).status, 0);
  };
  run({"-normals", "n1.png", "-depth", "5", "12", "d1.png"});
  run({"-normals", "n2.png", "-depth", "5", "12", "d2.png", "-jitter", "-filter"});
  EXPECT_EQ(Fingerprint("n1.png"), Fingerprint("n2.png"));
  EXPECT_EQ(Fingerprint("d1.png"), Fingerprint("d2.png"));
}

// The near sphere is darker than the far floor; with the ends exchanged it is the other way round.
TEST_F(Assignment4Test, DepthRangeMayRunBackwards) {
  const auto middle_and_floor = [&](const char* min, const char* max) {
    const ProgramEnd end = Assignment4({"-input", "scene.txt", "-size", "21", "21", "-depth", min,
                                        max, "d.pfm", "-normals", "n.png"});
    EXPECT_EQ(end.status, 0) << end.err;
    const ProgramEnd png =
        Assignment4({"-input", "scene.txt", "-size", "21", "21", "-depth", min, max, "d.png"});
    EXPECT_EQ(png.status, 0) << png.err;
    const Image raw = Picture("d.pfm"), image = Picture("d.png");
    EXPECT_NEAR(raw.At(10, 10), 7, 1e-5);  // The distance itself, whatever the range.
    return image.At(10, 10) - image.At(10, 20);
  };
  const float forwards = middle_and_floor("0", "12"), backwards = middle_and_floor("12", "0");
  EXPECT_NE(forwards, 0);
  EXPECT_LT(forwards * backwards, 0);
  EXPECT_EQ(Assignment4({"-input", "scene.txt", "-depth", "-1", "-5e0", "d.png"}).status, 0);
}

TEST_F(Assignment4Test, ASideOfOnePixelIsAPicture) {
  for (const auto& [w, h] : {std::pair("1", "1"), std::pair("1", "7"), std::pair("9", "1")}) {
    const ProgramEnd end =
        Assignment4({"-input", "scene.txt", "-size", w, h, "-output", "o.png", "-jitter"});
    EXPECT_EQ(end.status, 0) << end.err;
    EXPECT_EQ(std::to_string(Picture("o.png").Width()), w);
    EXPECT_EQ(std::to_string(Picture("o.png").Height()), h);
  }
}

TEST_F(Assignment4Test, FindsTheScenesThatShipWithIt) {
  std::filesystem::create_directories(folder_ / "assets" / "assignment4");
  Put(folder_ / "assets" / "assignment4" / "shipped.txt", kSmallScene);
  EXPECT_EQ(Assignment4({"-input", "shipped.txt", "-output", "o.png"}).status, 0);

  const ProgramEnd end = Assignment4({"-input", "shiped.txt", "-output", "o.png"});
  EXPECT_EQ(end.status, 1);
  EXPECT_THAT(end.err,
              HasSubstr("assignment4: error: there is no scene 'shiped.txt' (did you mean "
                        "'shipped.txt'?); looked for it as given, in 'assets/assignment4'"));
}

TEST_F(Assignment4Test, RefusesAWrongCommandLine) {
  const auto refused = [&](const std::vector<std::string>& arguments, const std::string& message) {
    const ProgramEnd end = Assignment4(arguments);
    ExpectRefusal(end, 2, "assignment4: error: " + message);
  };
  refused({}, "-input FILE is missing");
  refused({"-output", "o.png"}, "-input FILE is missing");
  refused({"-input", "scene.txt", "-ouput", "o.png"},
          "unknown option '-ouput' (did you mean '-output'?)");
  refused({"-input", "scene.txt", "-output", "o.png", "-size", "800"},
          "-size: expects W H, found only '800'");
  refused({"-input", "scene.txt", "-output", "o.png", "-size", "800", "0x10"},
          "-size: expects a whole number from 1 to 2147483647 for H, found '0x10'");
  refused({"-input", "scene.txt", "-output", "o.png", "-bounces", "-1"},
          "-bounces: expects a whole number from 0 to 2147483647, found '-1'");
  refused({"-input", "scene.txt", "-output", "o.png", "-bounces", "2147483648"},
          "-bounces: expects a whole number from 0 to 2147483647, found '2147483648'");
  refused({"-input", "scene.txt", "-depth", "3", "3", "d.png"},
          "-depth: MIN and MAX have to differ");
  refused({"-input", "scene.txt", "-depth", "3", "inf", "d.png"},
          "-depth: expects a number for MAX, found 'inf'");
  refused({"-input", "scene.txt"},
          "nothing to do: give -output FILE, -normals FILE or -depth MIN MAX FILE");
  refused({"-input", "scene.txt", "-output", "o.gif"},
          "'o.gif': the name of a picture has to end in .png, .jpg, .exr, .hdr or .pfm");
  EXPECT_THAT(folder_.Names(), ElementsAre("scene.txt"));
  EXPECT_THAT(Assignment4({}).err, HasSubstr("\nRun 'assignment4 -help' to see what it takes.\n"));
}

TEST_F(Assignment4Test, WritesNoFileTwiceAndNoneThatItReads) {
  const std::vector<std::string> input = {"-input", "scene.txt"};
  const auto refused = [&](std::vector<std::string> arguments, const std::string& message) {
    arguments.insert(arguments.begin(), input.begin(), input.end());
    ExpectRefusal(Assignment4(arguments), 2, "assignment4: error: " + message);
  };
  refused({"-output", "a.png", "-normals", "./a.png"}, "-output and -normals both write './a.png'");
  refused({"-normals", "a.png", "-depth", "0", "1", "a.png"},
          "-normals and -depth both write 'a.png'");

  std::filesystem::create_symlink("scene.txt", folder_ / "link.png");
  refused({"-output", "link.png"}, "-output: 'link.png' is the scene, which would be overwritten");
  EXPECT_EQ(Bytes("scene.txt"), kSmallScene);
}

TEST_F(Assignment4Test, WritesNoFileThatIsPartOfTheScene) {
  Put(folder_ / "mesh.png", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  Put(folder_ / "mesh.txt",
      "Camera { center 0 0 5 direction 0 0 -1 up 0 1 0 fov 40 } Materials { Material { } }\n"
      "Scene { Component<Material> { index 0 } Component<Object> { type mesh obj_file mesh.png } "
      "}");
  const ProgramEnd end = Assignment4({"-input", "mesh.txt", "-output", "mesh.png"});
  ExpectRefusal(
      end, 2, "assignment4: error: 'mesh.png' is a part of the scene, which would be overwritten");
  EXPECT_EQ(Bytes("mesh.png").substr(0, 1), "v");
}

TEST_F(Assignment4Test, RefusesAPictureThatWouldNotFit) {
  for (const auto& [w, h] :
       {std::pair("2147483647", "2147483647"), std::pair("1000000", "1000000")}) {
    const ProgramEnd end = Assignment4({"-input", "scene.txt", "-output", "o.png", "-size", w, h});
    EXPECT_EQ(end.status, 4);
    EXPECT_THAT(end.err, testing::MatchesRegex(fmt::format(
                             "assignment4: error: a picture of {} x {} pixels needs about "
                             "[0-9.]+ GiB of memory, [0-9.]+ GiB are free\n",
                             w, h)));
  }
  for (const char* side : {"2147483648", "9223372036854775808", "100000000000000000000000000"}) {
    ExpectRefusal(Assignment4({"-input", "scene.txt", "-output", "o.png", "-size", side, "1"}), 4,
                  "assignment4: error: -size: a side can have at most 2147483647 pixels");
  }
  EXPECT_THAT(folder_.Names(), ElementsAre("scene.txt"));
}

TEST_F(Assignment4Test, ChecksTheOutputBeforeItReadsTheScene) {
  Put(folder_ / "broken.txt", "nonsense");
  const ProgramEnd end = Assignment4({"-input", "broken.txt", "-output", "missing/o.png"});
  EXPECT_EQ(end.status, 3);
  EXPECT_THAT(end.err, testing::StartsWith("assignment4: error: 'missing/o.png': "));
}

TEST_F(Assignment4Test, ReportsAWrongSceneByItsPlaces) {
  Put(folder_ / "broken.txt", "Camera { fov nan }\nMaterial { }\n");
  const ProgramEnd end = Assignment4({"-input", "broken.txt", "-output", "o.png"});
  EXPECT_EQ(end.status, 1);
  EXPECT_EQ(end.out, "");
  EXPECT_THAT(end.err, HasSubstr("broken.txt:1:14: error: "));
  EXPECT_THAT(end.err, HasSubstr("broken.txt:2:1: error: "));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "o.png"));
}

TEST_F(Assignment4Test, HelpGoesToStdoutAndNamesEveryFlag) {
  for (const char* ask : {"-help", "--help"}) {
    const ProgramEnd end = Assignment4({ask});
    EXPECT_EQ(end.status, 0);
    EXPECT_EQ(end.err, "");
    for (const char* flag :
         {"\n  -input FILE ", "\n  -output FILE ", "\n  -size W H ", "\n  -bounces N ",
          "\n  -shadows ", "\n  -normals FILE ", "\n  -depth MIN MAX FILE ", "\n  -jitter ",
          "\n  -filter ", "\n  -stretch ", "\n  -help ", "\n  -version ", "\nExamples:\n"}) {
      EXPECT_THAT(end.out, HasSubstr(flag));
    }
  }
  EXPECT_THAT(Assignment4({"-version"}).out, testing::MatchesRegex("Candela [0-9.]+\n"));
}

}  // namespace
}  // namespace candela::testing_support
