// What `candela render` does with samples and their sums, run as a user does.
#include <cmath>
#include <csignal>

#include "film/layers.h"
#include "image/exr.h"
#include "tests/apps/programs.h"

namespace candela::testing_support {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

class FilmOptionsTest : public ProgramTest {
 protected:
  FilmOptionsTest() {
    Put(folder_ / "box.txt",
        "Camera { center 0 0 4 direction 0 0 -1 up 0 1 0 fov 60 }\n"
        "Background { color 0.1 0.2 0.3 ambient_light 0 0 0 }\n"
        "Materials { Material { type diffuse albedo 0.8 0.4 0.2 } }\n"
        "Scene {\n"
        "  Node { Component<Object> { type sphere radius 1 } Component<Material> { index 0 } }\n"
        "  Node { Component<Object> { type plane normal 0 1 0 offset -1 }\n"
        "         Component<Material> { index 0 } }\n"
        "  Node { Transform { translate 1.5 1.5 0 } Component<Object> { type sphere radius 0.3 }\n"
        "         Component<Material> { index 0 } Component<Light> { type area radiance 9 9 9 } }\n"
        "}\n");
  }

  ProgramEnd Render(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), {"render", "box.txt", "--size", "40", "30", "--quiet"});
    return Candela(arguments);
  }
  ProgramEnd RenderPath(std::vector<std::string> arguments) const {
    arguments.insert(arguments.end(), {"--integrator", "path"});
    return Render(arguments);
  }
  ExrPicture Layers(const std::string& name) const {
    auto picture = DecodeExrChannels(Bytes(name));
    EXPECT_TRUE(picture.ok());
    return picture ? std::move(picture).value() : ExrPicture();
  }
  void ExpectUsageError(const std::vector<std::string>& arguments, const std::string& message) {
    ExpectRefusal(Render(arguments), 2, "candela render: error: " + message);
  }
};

float At(const ExrPicture& picture, const std::string& channel, int x, int y) {
  const auto found = std::find(picture.channels.begin(), picture.channels.end(), channel);
  if (found == picture.channels.end()) {
    ADD_FAILURE() << "no channel " << channel;
    return 0;
  }
  return picture.image.At(x, y, static_cast<int>(found - picture.channels.begin()));
}

TEST_F(FilmOptionsTest, AllLayersAreInOneFileWithThePicture) {
  EXPECT_EQ(RenderPath({"-o", "plain.exr", "--samples", "16"}).status, 0);
  EXPECT_EQ(RenderPath({"-o", "all.exr", "--samples", "16", "--aov", "all"}).status, 0);
  EXPECT_EQ(Picture("all.exr"), Picture("plain.exr"));
  const ExrPicture all = Layers("all.exr");
  EXPECT_THAT(
      all.channels,
      ElementsAre("B", "G", "R", "albedo.B", "albedo.G", "albedo.R", "depth.Z", "direct.B",
                  "direct.G", "direct.R", "emission.B", "emission.G", "emission.R",
                  "geometric_normal.X", "geometric_normal.Y", "geometric_normal.Z", "indirect.B",
                  "indirect.G", "indirect.R", "material_id.X", "normal.X", "normal.Y", "normal.Z",
                  "object_id.X", "position.X", "position.Y", "position.Z", "sample_count.X",
                  "standard_error.B", "standard_error.G", "standard_error.R", "uv.U", "uv.V"));
  for (int y = 0; y < 30; ++y) {
    for (int x = 0; x < 40; ++x) {
      for (const char* c : {"R", "G", "B"}) {
        const std::string dot = std::string(".") + c;
        const float sum = At(all, "direct" + dot, x, y) + At(all, "indirect" + dot, x, y) +
                          At(all, "emission" + dot, x, y);
        ASSERT_NEAR(sum, At(all, c, x, y), 2e-6f * (1 + sum)) << x << " " << y;
      }
      ASSERT_EQ(At(all, "sample_count.X", x, y), 16);
    }
  }
  EXPECT_EQ(At(all, "object_id.X", 20, 15), 1);
  EXPECT_NEAR(At(all, "depth.Z", 20, 15), 3, 0.05);
  EXPECT_NEAR(At(all, "albedo.R", 20, 15), 0.8f, 1e-6);
  EXPECT_GT(At(all, "standard_error.R", 20, 15), 0);
  EXPECT_EQ(At(all, "object_id.X", 0, 0), 0);
  EXPECT_EQ(At(all, "depth.Z", 0, 0), 1e10f);
  EXPECT_NEAR(At(all, "emission.B", 0, 0), 0.3f, 1e-6);
}

TEST_F(FilmOptionsTest, LayersDoNotDependOnThreads) {
  EXPECT_EQ(RenderPath({"-o", "1.exr", "--samples", "8", "--aov", "all", "--threads", "1"}).status,
            0);
  EXPECT_EQ(RenderPath({"-o", "7.exr", "--samples", "8", "--aov", "all", "--threads", "7"}).status,
            0);
  EXPECT_TRUE(Bytes("1.exr") == Bytes("7.exr"));
}

TEST_F(FilmOptionsTest, TheCoursesIntegratorHasLayersToo) {
  EXPECT_EQ(Render({"-o", "o.exr", "--aov", "normal,object_id"}).status, 0);
  const ExrPicture picture = Layers("o.exr");
  EXPECT_THAT(picture.channels,
              ElementsAre("B", "G", "R", "normal.X", "normal.Y", "normal.Z", "object_id.X"));
  EXPECT_GT(At(picture, "normal.Z", 20, 15), 0.9f);
}

// Whatever is done to samples.
TEST_F(FilmOptionsTest, LayersOfLightGroupsAreTogetherThePicture) {
  Put(folder_ / "groups.txt",
      "Camera { center 0 0 4 direction 0 0 -1 up 0 1 0 fov 60 }\n"
      "Background { color 0.1 0.2 0.3 }\n"
      "Materials { Material { type diffuse albedo 0.8 0.4 0.2 } }\n"
      "Scene {\n"
      "  Node { Component<Object> { type plane normal 0 1 0 offset -1 }\n"
      "         Component<Material> { index 0 } }\n"
      "  Node { Transform { translate 1.5 1.5 0 } Component<Object> { type sphere radius 0.3 }\n"
      "         Component<Material> { index 0 }\n"
      "         Component<Light> { type area radiance 90 90 90 group ceiling_lamps_of_the_hall_2 } "
      "}\n"
      "  Node { Transform { translate -1 1 0 }\n"
      "         Component<Light> { type point attenuation 0.5 group lamp } } }\n");
  const std::vector<std::vector<std::string>> ways = {
      {"--samples", "16"},
      {"--samples", "16", "--filter", "mitchell"},
      {"--samples", "16", "--clamp", "0.7"},
      {"--samples", "64", "--noise-target", "0.2"},
      {"--samples", "16", "--time-limit", "100"},
      {"--samples", "64", "--noise-target", "0.2", "--clamp", "0.7", "--crop", "3", "5", "38",
       "29"}};
  for (const auto& way : ways) {
    SCOPED_TRACE(way.back());
    std::vector<std::string> words = {"render",  "groups.txt", "--size",    "40",           "30",
                                      "--quiet", "-o",         "plain.exr", "--integrator", "path"};
    words.insert(words.end(), way.begin(), way.end());
    EXPECT_EQ(Candela(words).status, 0);
    words[7] = "groups.exr";
    words.insert(words.end(), {"--aov", "light_groups"});
    EXPECT_EQ(Candela(words).status, 0);
    EXPECT_EQ(Picture("groups.exr"), Picture("plain.exr"));
    const ExrPicture picture = Layers("groups.exr");
    EXPECT_THAT(picture.channels,
                ElementsAre("B", "G", "R", "light_group_ceiling_lamps_of_the_hall_2.B",
                            "light_group_ceiling_lamps_of_the_hall_2.G",
                            "light_group_ceiling_lamps_of_the_hall_2.R", "light_group_default.B",
                            "light_group_default.G", "light_group_default.R", "light_group_lamp.B",
                            "light_group_lamp.G", "light_group_lamp.R"));
    float most_of_hall = 0, most_of_lamp = 0;
    for (int y = 0; y < picture.image.Height(); ++y) {
      for (int x = 0; x < picture.image.Width(); ++x) {
        for (const char* c : {".R", ".G", ".B"}) {
          const float hall =
              At(picture, "light_group_ceiling_lamps_of_the_hall_2" + std::string(c), x, y);
          const float lamp = At(picture, "light_group_lamp" + std::string(c), x, y);
          const float sum = hall + lamp + At(picture, "light_group_default" + std::string(c), x, y);
          ASSERT_NEAR(sum, At(picture, c + 1, x, y), 4e-6f * (1 + std::abs(hall) + std::abs(lamp)))
              << x << " " << y;
          most_of_hall = std::max(most_of_hall, hall);
          most_of_lamp = std::max(most_of_lamp, lamp);
        }
      }
    }
    EXPECT_GT(most_of_hall, 0.5f);
    EXPECT_GT(most_of_lamp, 0.1f);
  }
}

TEST_F(FilmOptionsTest, RefusesLayersThatCannotBe) {
  ExpectUsageError(
      {"-o", "o.exr", "--aov", "normal,light_groups"},
      "--aov light_groups: the integrator 'whitted' does not tell the light of groups apart");
  ExpectUsageError({"-o", "o.png", "--aov", "all"},
                   "--aov: layers go into the picture of --output, which has to be an .exr file");
  ExpectUsageError({"--normals", "n.exr", "--aov", "all"},
                   "--aov: layers go into the picture of --output, which has to be an .exr file");
  const ProgramEnd end = Render({"-o", "o.exr", "--aov", "depth,nromal"});
  EXPECT_EQ(end.status, 2);
  EXPECT_THAT(end.err, HasSubstr("'depth', 'position', 'normal'"));
  EXPECT_THAT(end.err, HasSubstr("found 'depth,nromal'"));
  EXPECT_EQ(Render({"-o", "o.exr", "--aov", "depth,"}).status, 2);
}

TEST_F(FilmOptionsTest, FilesTellHowTheyWereMade) {
  EXPECT_EQ(RenderPath({"-o", "a.exr", "--samples", "2", "--seed", "77"}).status, 0);
  EXPECT_EQ(RenderPath({"-o", "b.exr", "--samples", "2", "--seed", "77"}).status, 0);
  const std::string bytes = Bytes("a.exr");
  EXPECT_TRUE(bytes == Bytes("b.exr"));
  for (const char* text : {"candela/scene_hash", "candela/samples", "Candela 0.",
                           "--integrator path", "--seed 77", "--sampler sobol"}) {
    EXPECT_NE(bytes.find(text), std::string::npos) << text;
  }
  // Another scene has another hash; where it lies does not count.
  const auto hash_of = [this](const std::string& name) {
    const std::string file = Bytes(name);
    return file.substr(file.find("candela/scene_hash") + 30, 20);
  };
  std::filesystem::create_directory(folder_ / "away");
  Put(folder_ / "away" / "moved.txt", Bytes("box.txt"));
  Put(folder_ / "other.txt", Bytes("box.txt") + "\n");
  for (const auto& [scene, out] :
       {std::pair("away/moved.txt", "moved.exr"), std::pair("other.txt", "other.exr")}) {
    EXPECT_EQ(Candela({"render", scene, "--size", "4", "4", "-o", out}).status, 0);
  }
  EXPECT_EQ(hash_of("moved.exr"), hash_of("a.exr"));
  EXPECT_NE(hash_of("other.exr"), hash_of("a.exr"));
}

TEST_F(FilmOptionsTest, ClampTellsWhatItTakes) {
  const ProgramEnd end = RenderPath({"-o", "o.exr", "--samples", "4", "--clamp", "1"});
  EXPECT_EQ(end.status, 0);
  EXPECT_THAT(end.err, testing::ContainsRegex("--clamp has taken [0-9.]+ % of the light, in "
                                              "[0-9]+ samples"));
  const auto samples = Picture("o.exr");
  for (const float value : samples.Samples()) ASSERT_LE(value, 1);
  EXPECT_EQ(RenderPath({"-o", "o.exr", "--samples", "4", "--clamp", "1e6"}).err, "");
  ExpectUsageError({"-o", "o.exr", "--clamp", "0"}, "--clamp: expects a number above 0, found '0'");
}

TEST_F(FilmOptionsTest, NoiseTargetGivesSamplesWhereTheyAreNeeded) {
  const auto render = [this](const std::string& name, std::vector<std::string> more) {
    std::vector<std::string> words = {"-o", name, "--aov", "sample_count,standard_error"};
    words.insert(words.end(), more.begin(), more.end());
    return RenderPath(words);
  };
  EXPECT_EQ(render("a.exr", {"--noise-target", "0.03", "--threads", "1"}).err, "");
  EXPECT_EQ(render("b.exr", {"--noise-target", "0.03", "--threads", "3"}).status, 0);
  EXPECT_TRUE(Bytes("a.exr") == Bytes("b.exr"));
  const ExrPicture picture = Layers("a.exr");
  std::set<float> counts;
  for (int x : {0, 20, 39}) counts.insert(At(picture, "sample_count.X", x, 15));
  EXPECT_EQ(counts.size(), 3u);  // Each block has as many as it needs.
  EXPECT_GE(*counts.begin(), 32);
  int quiet = 0;
  for (int y = 0; y < 30; ++y) {
    for (int x = 0; x < 40; ++x) {
      if (At(picture, "standard_error.G", x, y) <= 0.03f * At(picture, "G", x, y)) ++quiet;
    }
  }
  EXPECT_GE(quiet, 0.95 * 30 * 40);
  const ProgramEnd end = render("c.exr", {"--noise-target", "0.001", "--samples", "40"});
  EXPECT_EQ(end.status, 0);
  EXPECT_THAT(end.err, testing::ContainsRegex("warning: [0-9.]+ % of the pixels are in blocks that "
                                              "are still noisier than the noise target"));
}

TEST_F(FilmOptionsTest, TimeLimitEndsTheWork) {
  const ProgramEnd end = RenderPath({"-o", "a.exr", "--time-limit", "0", "--stats"});
  EXPECT_EQ(end.status, 0);
  EXPECT_THAT(end.err, HasSubstr("1 samples each"));
  EXPECT_EQ(RenderPath({"-o", "b.exr", "--samples", "1", "--filter", "box"}).status, 0);
  EXPECT_EQ(Picture("a.exr"), Picture("b.exr"));
}

TEST_F(FilmOptionsTest, RefusesEndsThatCannotBe) {
  ExpectUsageError({"-o", "o.exr", "--noise-target", "0"},
                   "--noise-target: expects a number above 0, found '0'");
  ExpectUsageError({"-o", "o.exr", "--time-limit", "-1"},
                   "--time-limit: expects a number of at least 0, found '-1'");
  ExpectUsageError({"-o", "o.exr", "--jitter", "--time-limit", "1"},
                   "--jitter and --time-limit: give one of them");
  ExpectUsageError({"-o", "o.exr", "--integrator", "light_trace", "--noise-target", "1"},
                   "--noise-target: how many light paths 'light_trace' follows is known before it "
                   "begins");
  ExpectUsageError({"-o", "o.exr", "--noise-target", "1", "--checkpoint", "c"},
                   "--noise-target: a checkpoint holds pixels that all have as many samples");
}

TEST_F(FilmOptionsTest, SamplesThatAreNoLightAreNamed) {
  Put(folder_ / "box.txt",
      "Camera { center 0 0 4 direction 0 0 -1 up 0 1 0 fov 60 }\n"
      "Background { color 1 -0.5 1 ambient_light 0 0 0 }\nScene { }\n");
  const ProgramEnd end = RenderPath({"-o", "o.exr", "--samples", "2"});
  EXPECT_EQ(end.status, 0);
  EXPECT_THAT(end.err, HasSubstr("candela render: warning: pixel 0 0, sample 0: the light 1 -0.5 1 "
                                 "is not possible and is left out\n"));
  EXPECT_THAT(end.err, HasSubstr("pixel 2 0, sample 0"));
  EXPECT_THAT(end.err, HasSubstr("2400 samples were left out in all\n"));
  // The course knows lights that take away.
  EXPECT_EQ(Render({"-o", "o.exr"}).err, "");
  EXPECT_EQ(Picture("o.exr").At(0, 0, 1), -0.5f);
}

TEST_F(FilmOptionsTest, ACheckpointGoesOnAtWill) {
  EXPECT_EQ(RenderPath({"-o", "whole.exr", "--samples", "50"}).status, 0);
  for (const char* samples : {"10", "31", "50"}) {
    const ProgramEnd end =
        RenderPath({"-o", "o.exr", "--samples", samples, "--checkpoint", "c.bin"});
    EXPECT_EQ(end.status, 0) << end.err;
  }
  EXPECT_TRUE(Bytes("o.exr") == Bytes("whole.exr"));
  const ProgramEnd less = RenderPath({"-o", "o.exr", "--samples", "20", "--checkpoint", "c.bin"});
  ExpectRefusal(less, 1,
                "candela render: error: 'c.bin': holds 50 samples of each pixel already, more than "
                "the 20 asked for");
}

TEST_F(FilmOptionsTest, ACheckpointOfSomethingElseIsRefused) {
  const std::vector<std::string> usual = {"-o", "o.exr", "--samples", "4", "--checkpoint", "c.bin"};
  EXPECT_EQ(RenderPath(usual).status, 0);
  auto seeded = usual;
  seeded.insert(seeded.end(), {"--seed", "3"});
  EXPECT_THAT(RenderPath(seeded).err, HasSubstr("'c.bin': was made with other options, --size"));
  const std::string bytes = Bytes("c.bin"), scene = Bytes("box.txt");
  Put(folder_ / "c.bin", bytes.substr(0, bytes.size() / 2));
  EXPECT_THAT(RenderPath(usual).err, HasSubstr("'c.bin': is truncated or damaged"));
  Put(folder_ / "c.bin", "a shopping list");
  EXPECT_THAT(RenderPath(usual).err, HasSubstr("'c.bin': is not a checkpoint"));
  EXPECT_EQ(Bytes("c.bin"), "a shopping list");
  Put(folder_ / "c.bin", bytes);
  Put(folder_ / "box.txt", scene + " ");
  EXPECT_THAT(RenderPath(usual).err, HasSubstr("'c.bin': belongs to another scene"));
  ExpectUsageError({"-o", "o.exr", "--aov", "all", "--checkpoint", "c.bin"},
                   "--checkpoint and --aov: a checkpoint does not hold layers");
  ExpectUsageError({"--normals", "o.exr", "--checkpoint", "c.bin"},
                   "--checkpoint keeps the picture of --output: give both");
  ExpectUsageError({"-o", "c.png", "--checkpoint", "c.png"},
                   "--output and --checkpoint both write 'c.png'");
}

class StoppedWithCheckpoint : public FilmOptionsTest, public testing::WithParamInterface<int> {};

TEST_P(StoppedWithCheckpoint, SavesAndGoesOn) {
  // So many that it has not ended when the first of them are kept and the signal comes.
  const std::string samples = "64";
  const std::vector<std::string> arguments = {
      "render", "box.txt",   "--size", "200",          "200",   "--integrator",       "path", "-o",
      "o.exr",  "--samples", samples,  "--checkpoint", "c.bin", "--checkpoint-every", "0"};
  auto whole = arguments;
  whole.resize(11);
  EXPECT_EQ(Candela(whole).status, 0);
  const std::string expected = Bytes("o.exr");
  std::filesystem::remove(folder_ / "o.exr");
  {
    Program program(CANDELA_PROGRAM, arguments, setup_);
    while (!std::filesystem::exists(folder_ / "c.bin")) {
      ASSERT_FALSE(program.WaitForError("error", 0.02));
    }
    program.Signal(GetParam());
    const ProgramEnd end = program.Finish();
    if (GetParam() == SIGKILL) {
      EXPECT_EQ(end.status, 1000 + SIGKILL);
    } else {
      EXPECT_EQ(end.status, 5);
      EXPECT_THAT(end.err, HasSubstr("samples are kept in 'c.bin', and the same command line goes "
                                     "on from there"));
    }
    EXPECT_FALSE(std::filesystem::exists(folder_ / "o.exr"));
  }
  EXPECT_EQ(Candela(arguments).status, 0);
  EXPECT_TRUE(Bytes("o.exr") == expected);
}

INSTANTIATE_TEST_SUITE_P(All, StoppedWithCheckpoint, testing::Values(SIGINT, SIGTERM, SIGKILL),
                         testing::PrintToStringParamName());

}  // namespace
}  // namespace candela::testing_support
