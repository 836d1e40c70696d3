// What scenes say about their rendering, as a user sees it.
#include <fmt/format.h>

#include "tests/apps/programs.h"

namespace candela::testing_support {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr const char* kDiffuseScene = R"(
Camera { center 0 1 8 direction 0 0 -1 up 0 1 0 fov 40 }
Background { color 1 0.5 0.25 }
Materials { Material { type diffuse } }
Scene { Component<Material> { index 0 } Component<Object> { type sphere radius 1 } }
)";

class SceneSettingsTest : public ProgramTest {
 protected:
  void PutScene(const std::string& settings) const {
    Put(folder_ / "scene.txt", settings + kDiffuseScene);
  }
  /// The fingerprint of the picture that these settings and arguments give.
  size_t Rendered(const std::string& settings, std::vector<std::string> arguments,
                  const std::string& file = "o.png") const {
    PutScene(settings);
    arguments.insert(arguments.begin(), {"render", "scene.txt", "-o", file, "--quiet"});
    const ProgramEnd end = Candela(arguments);
    EXPECT_EQ(end.status, 0) << end.err;
    EXPECT_EQ(end.err, "");
    return Fingerprint(file);
  }
  std::string Checked(const std::string& settings) const {
    PutScene(settings);
    const ProgramEnd end = Candela({"check", "scene.txt"});
    EXPECT_EQ(end.status, end.err.empty() ? 0 : 1);
    // Rendering says the same, and renders nothing.
    EXPECT_EQ(Candela({"render", "scene.txt", "-o", "no.png"}).err.substr(0, end.err.size()),
              end.err);
    EXPECT_EQ(std::filesystem::exists(folder_ / "no.png"), end.err.empty());
    return end.err;
  }
};

TEST_F(SceneSettingsTest, AreOptions) {
  const struct {
    const char* settings;
    std::vector<std::string> options;
  } pairs[] = {
      {"Render { integrator path samples 4 seed 7 bounces 2 diffuse_bounces 1 }",
       {"--integrator", "path", "--samples=4", "--seed=7", "--bounces=2", "--diffuse-bounces=1"}},
      {"Render { samples 3 shadows true } Film { filter gaussian tonemap filmic exposure -0.5 }",
       {"--samples=3", "--shadows", "--filter=gaussian", "--tonemap=filmic", "--exposure=-0.5"}},
      {"Render { indirect_samples 4 indirect_sampling uniform }",
       {"--indirect-samples=4", "--indirect-sampling=uniform"}},
      {"Film { pixel_grid centres stretch true }", {"--pixel-grid=centres", "--stretch"}},
      // What follows from others follows from them wherever they stand.
      {"Render { integrator path }", {"--integrator=path"}},
      {"Film { filter tent }", {"--filter=tent"}},
  };
  for (const auto& [settings, options] : pairs) {
    std::vector<std::string> all = options;
    all.insert(all.end(), {"--size", "20", "16"});
    EXPECT_EQ(Rendered(settings, {"--size", "20", "16"}), Rendered("", all)) << settings;
  }
}

TEST_F(SceneSettingsTest, TheSizeIsTheirs) {
  Rendered("Film { size 24 12 }", {});
  EXPECT_EQ(Picture("o.png").Width(), 24);
  EXPECT_EQ(Picture("o.png").Height(), 12);
  // The window of a crop lies in it.
  EXPECT_EQ(Candela({"render", "scene.txt", "-o", "o.png", "--crop", "0", "0", "25", "5"}).err,
            "candela render: error: --crop: reaches beyond the picture of 24 x 12 pixels\n");
}

TEST_F(SceneSettingsTest, TheCommandLineWins) {
  const std::string all =
      "Render { integrator path samples 9 shadows true seed 3 }\n"
      "Film { size 9 9 filter mitchell tonemap agx exposure 2 pixel_grid centres stretch true }\n";
  EXPECT_EQ(Rendered(all, {"--integrator=whitted", "--samples=2", "--shadows=false", "--seed=1",
                           "--size", "20", "10", "--filter=box", "--tonemap=srgb", "--exposure=0",
                           "--pixel-grid=corners", "--stretch=false"}),
            Rendered("", {"--samples=2", "--seed=1", "--size", "20", "10", "--filter=box",
                          "--tonemap=srgb"}));
}

// The samples of the course are a number and a filter of their own.
TEST_F(SceneSettingsTest, JitterTakesThePlaceOfSamplesAndFilter) {
  EXPECT_EQ(Rendered("Render { samples 3 } Film { filter gaussian }", {"--jitter"}),
            Rendered("", {"--jitter"}));
}

// An exposure concerns pictures for eyes; a file that holds the light itself has none. (An .exr
// file would tell which options it was made with.)
TEST_F(SceneSettingsTest, TheToneCurveLeavesTheLightItself) {
  EXPECT_EQ(Rendered("Film { tonemap agx exposure 2 size 9 9 }", {}, "o.pfm"),
            Rendered("", {"--size", "9", "9"}, "o.pfm"));
}

TEST_F(SceneSettingsTest, WrongOnesArePlaced) {
  EXPECT_EQ(Checked("Render { sampels 4 }"),
            "scene.txt:1:10: error: parameter 'sampels' is not used by 'Render' (did you mean "
            "'samples'?)\n");
  EXPECT_EQ(
      Checked("Film { filter gausian }"),
      "scene.txt:1:15: error: 'filter' expects 'box', 'tent', 'gaussian', 'blackman_harris' or "
      "'mitchell', found 'gausian' (did you mean 'gaussian'?)\n");
  EXPECT_EQ(Checked("Render { samples 0 }"),
            "scene.txt:1:18: error: 'samples' expects a whole number from 1 to 2147483647, found "
            "'0'\n");
  EXPECT_EQ(Checked("Film { size 640 }"),
            "scene.txt:1:8: error: 'size' expects 2 values: W H, found 1 number\n");
  EXPECT_EQ(
      Checked("Film { size 640 x }"),
      "scene.txt:1:17: error: 'size' expects a whole number from 1 to 2147483647 for H, found "
      "'x'\n");
  EXPECT_EQ(Checked("Render { shadows yes }"),
            "scene.txt:1:18: error: 'shadows' expects 'true' or 'false', found 'yes'\n");
  EXPECT_EQ(Checked("Render { filter box }"),
            "scene.txt:1:10: error: 'filter' belongs in the block 'Film', not in 'Render'\n");
  EXPECT_EQ(Checked("Film { tonemap }"),
            "scene.txt:1:8: error: 'tonemap' expects 'none', 'srgb', 'filmic' or 'agx', found "
            "nothing\n");
}

// Light paths have no samples to clamp. Whoever asks for them cannot switch off what a scene
// clamps.
TEST_F(SceneSettingsTest, ThoseThatExcludeEachOtherArePlaced) {
  EXPECT_EQ(
      Checked("Render { integrator light_trace clamp 2 }"),
      "scene.txt:1:33: error: 'clamp': what light paths of 'light_trace' bring has no samples "
      "to clamp\n");
  PutScene("Render { integrator path clamp 2 samples 1 }");
  const ProgramEnd end =
      Candela({"render", "scene.txt", "-o", "a.exr", "--integrator", "light_trace"});
  EXPECT_EQ(end.status, 0);
  EXPECT_EQ(end.err,
            "scene.txt:1:26: warning: 'clamp' has no effect: what light paths of 'light_trace' "
            "bring has no samples to clamp\n");
  ExpectRefusal(Candela({"render", "scene.txt", "-o", "a.exr", "--integrator", "light_trace",
                         "--clamp", "3"}),
                2,
                "candela render: error: --clamp: what light paths of 'light_trace' bring has no "
                "samples to clamp");
}

// The same for what ends a picture, and for a noise that is not that of single pixels.
TEST_F(SceneSettingsTest, EndsThatCannotBeReachedArePlaced) {
  EXPECT_EQ(Checked("Render { integrator light_trace time_limit 2 }"),
            "scene.txt:1:33: error: 'time_limit': how many light paths 'light_trace' follows is "
            "known before it begins\n");
  EXPECT_EQ(Checked("Render { integrator path sampler blue_noise noise_target 0.1 }"),
            "scene.txt:1:45: error: 'noise_target': the noise of pixels with the sampler "
            "'blue_noise' depends on their neighbours\n");
  PutScene("Render { integrator path noise_target 0.1 samples 2 }");
  const ProgramEnd end =
      Candela({"render", "scene.txt", "-o", "a.exr", "--integrator", "light_trace"});
  EXPECT_EQ(end.status, 0);
  EXPECT_EQ(end.err,
            "scene.txt:1:26: warning: 'noise_target' has no effect: how many light paths "
            "'light_trace' follows is known before it begins\n");
  EXPECT_EQ(Candela({"render", "scene.txt", "-o", "a.exr", "--checkpoint", "c"}).err,
            "scene.txt:1:26: warning: 'noise_target' has no effect: a checkpoint holds pixels that "
            "all have as many samples\n");
  // Whoever asks for the course's samples gets them.
  EXPECT_EQ(Candela({"render", "scene.txt", "-o", "a.exr", "--jitter"}).err, "");
}

// They are warned of where they stand, in the scene or on the command line, and change nothing.
TEST_F(SceneSettingsTest, ThoseThatTheIntegratorDoesNotKnowHaveNoEffect) {
  constexpr const char* kShadows = " has no effect with the integrator 'path'\n";
  constexpr const char* kBounces = " has no effect with the integrator 'whitted'\n";
  const auto err = [&](const std::string& settings, std::vector<std::string> arguments) {
    PutScene(settings);
    arguments.insert(arguments.begin(), {"render", "scene.txt", "-o", "o.png", "--size", "9", "9"});
    const ProgramEnd end = Candela(arguments);
    EXPECT_EQ(end.status, 0);
    return end.err;
  };
  EXPECT_EQ(err("", {"--integrator", "path", "--shadows"}),
            std::string("candela render: warning: --shadows") + kShadows);
  EXPECT_EQ(err("Render { shadows true }", {"--integrator", "path"}),
            std::string("scene.txt:1:10: warning: 'shadows'") + kShadows);
  EXPECT_EQ(err("Render { shadows true }", {"--integrator", "path", "--shadows=false"}), "");
  EXPECT_EQ(err("Render { integrator path diffuse_bounces 1 }", {"--integrator", "whitted"}),
            std::string("scene.txt:1:26: warning: 'diffuse_bounces'") + kBounces);
  EXPECT_EQ(err("", {"--mirror-bounces", "1", "--transmission-bounces", "2"}),
            std::string("candela render: warning: --mirror-bounces") + kBounces +
                "candela render: warning: --transmission-bounces" + kBounces);

  PutScene("Render { integrator path shadows true }");
  EXPECT_THAT(Candela({"info", "--resolved", "scene.txt"}).out, HasSubstr("shadows false"));
}

// They are about the machine and the files of whoever renders.
TEST_F(SceneSettingsTest, ScenesCannotSetEverything) {
  for (const char* name : {"threads", "output", "quiet", "isa", "stats_json", "png_bits"}) {
    EXPECT_EQ(Checked(fmt::format("Render {{ {} 1 }}", name)),
              fmt::format("scene.txt:1:10: error: '{}' is for the command line alone: a scene "
                          "cannot set it\n",
                          name));
  }
}

TEST_F(SceneSettingsTest, AWrongCommandLineShowsWhereverItIsUsed) {
  ExpectRefusal(Candela({"render", "missing.txt", "-o", "o.png", "--jitter", "--samples", "2"}), 2,
                "candela render: error: --jitter and --samples: give one of them");
}

TEST_F(SceneSettingsTest, TheCourseProgramKeepsToItsCommandLine) {
  PutScene("");
  EXPECT_EQ(Assignment4({"-input", "scene.txt", "-output", "a.png"}).err, "");
  PutScene("Film { size 9 9 } ");
  EXPECT_EQ(Assignment4({"-input", "scene.txt", "-output", "b.png"}).err,
            "scene.txt:1:1: warning: 'Film' is for 'candela render'; this program does what its "
            "command line says\n");
  EXPECT_EQ(Fingerprint("a.png"), Fingerprint("b.png"));
}

TEST_F(SceneSettingsTest, OptionsOfOtherIntegratorsAreWarnedOf) {
  const auto err = [&](const std::string& settings, std::vector<std::string> arguments) {
    PutScene(settings);
    arguments.insert(arguments.begin(), {"render", "scene.txt", "-o", "o.png", "--size", "9", "9"});
    const ProgramEnd end = Candela(arguments);
    EXPECT_EQ(end.status, 0);
    return end.err;
  };
  const auto no_effect = [](const std::string& integrator) {
    return " has no effect with the integrator '" + integrator + "'\n";
  };
  EXPECT_EQ(err("", {"--integrator", "direct", "--bounces", "3"}),
            "candela render: warning: --bounces" + no_effect("direct"));
  EXPECT_EQ(err("", {"--view", "uv"}), "candela render: warning: --view" + no_effect("whitted"));
  EXPECT_EQ(err("Render { integrator path ao_distance 2 }", {}),
            "scene.txt:1:26: warning: 'ao_distance'" + no_effect("path"));
  EXPECT_EQ(err("Render { integrator ambient_occlusion ao_distance 2 }", {}), "");
  EXPECT_EQ(err("Render { integrator whitted light_choice power }", {}),
            "scene.txt:1:29: warning: 'light_choice'" + no_effect("whitted"));
  EXPECT_EQ(err("Render { integrator direct light_choice power }", {}), "");
  EXPECT_EQ(err("Render { integrator debug view cost bounces 2 light_choice power }", {}), "");
  EXPECT_THAT(Candela({"info", "scene.txt"}).out, HasSubstr("view cost"));
  EXPECT_EQ(err("Render { integrator debug view uv bounces 2 }", {"--shadows"}),
            "candela render: warning: --shadows has no effect with the view 'uv'\n"
            "scene.txt:1:35: warning: 'bounces' has no effect with the view 'uv'\n");
  EXPECT_EQ(err("Render { integrator debug bounces 2 }", {}),
            "scene.txt:1:27: warning: 'bounces' has no effect with the view 'normal'\n");
}

TEST_F(SceneSettingsTest, OptionsOfDistributionChangeWhatTheyAreAbout) {
  const size_t plain = Rendered("", {"--size", "20", "16"});
  const size_t gathered = Rendered("", {"--size", "20", "16", "--indirect-samples", "4"});
  EXPECT_NE(gathered, plain);
  EXPECT_NE(Rendered("", {"--size", "20", "16", "--indirect-samples", "4", "--indirect-sampling",
                          "uniform"}),
            gathered);
  // Neither lamps nor glossy surfaces nor a lens.
  EXPECT_EQ(Rendered("", {"--size", "20", "16", "--light-samples", "4", "--glossy-samples", "4",
                          "--depth-of-field"}),
            plain);
}

TEST_F(SceneSettingsTest, LampsThatLightNothingAreNamed) {
  const auto err = [&](const std::string& shape, std::vector<std::string> arguments) {
    Put(folder_ / "lamp.txt",
        "Camera { center 0 1 8 direction 0 0 -1 up 0 1 0 fov 40 } Materials { Material { } }"
        "Scene { Component<Material> { index 0 } Component<Object> { type " +
            shape + " } Component<Light> { type area } }");
    arguments.insert(arguments.begin(), {"render", "lamp.txt", "-o", "o.png", "--size", "9", "9"});
    return Candela(arguments).err;
  };
  EXPECT_EQ(
      err("sphere radius 1", {}),
      "candela render: warning: area lights shine but light nothing in 'whitted'; 'candela "
      "render --light-samples N' samples them, and '--integrator path' follows their light\n");
  EXPECT_EQ(err("sphere radius 1", {"--light-samples", "1"}), "");
  EXPECT_EQ(err("sphere radius 1", {"--indirect-samples", "1"}), "");
  EXPECT_EQ(err("plane normal 0 1 0 offset -1", {"--light-samples", "1"}),
            "candela render: warning: area lights of this shape shine but light nothing in "
            "'whitted'; '--integrator path' follows their light\n");
}

TEST_F(SceneSettingsTest, ScenesChooseTheAccelerator) {
  PutScene("Render { accelerator grid }");
  EXPECT_THAT(Candela({"info", "scene.txt"}).out, HasSubstr("\naccelerator grid, "));
  EXPECT_THAT(Candela({"info", "--resolved", "scene.txt"}).out,
              HasSubstr("\n  accelerator grid\n"));
  const auto err = [&](std::vector<std::string> more) {
    more.insert(more.begin(),
                {"render", "scene.txt", "-o", "o.png", "--size", "9", "9", "--stats"});
    return Candela(more).err;
  };
  EXPECT_THAT(err({}), HasSubstr(" threads, grid, "));
  EXPECT_THAT(err({"--accelerator", "octree"}), HasSubstr(" threads, octree, "));
}

TEST_F(SceneSettingsTest, ResolvedScenesHoldThem) {
  PutScene("Render { integrator path samples 2 } Film { size 20 10 }");
  const ProgramEnd resolved = Candela({"info", "--resolved", "scene.txt"});
  EXPECT_EQ(resolved.status, 0);
  EXPECT_THAT(resolved.out, HasSubstr("\n  samples 2\n"));
  EXPECT_THAT(resolved.out, HasSubstr("\n  filter box\n"));
  EXPECT_THAT(resolved.out, HasSubstr("\n  tonemap srgb\n"));
  Put(folder_ / "resolved.txt", resolved.out);
  EXPECT_EQ(Candela({"info", "--resolved", "resolved.txt"}).out, resolved.out);
  EXPECT_EQ(Candela({"render", "scene.txt", "-o", "a.png"}).status, 0);
  EXPECT_EQ(Candela({"render", "resolved.txt", "-o", "b.png"}).status, 0);
  EXPECT_EQ(Fingerprint("a.png"), Fingerprint("b.png"));
}

// The usual picture of the course has no filter and no curve, and none is made up for it.
TEST_F(SceneSettingsTest, ResolvedScenesHoldNothingWithoutEffect) {
  const ProgramEnd resolved = Candela({"info", "--resolved", "scene.txt"});
  EXPECT_THAT(resolved.out, HasSubstr("\n  bounces 0\n"));
  EXPECT_THAT(resolved.out, Not(HasSubstr("filter")));
  EXPECT_THAT(resolved.out, Not(HasSubstr("exposure")));
  Put(folder_ / "resolved.txt", resolved.out);
  EXPECT_EQ(Candela({"render", "scene.txt", "-o", "a.png"}).status, 0);
  EXPECT_EQ(Candela({"render", "resolved.txt", "-o", "b.png"}).status, 0);
  EXPECT_EQ(Fingerprint("a.png"), Fingerprint("b.png"));
}

TEST_F(SceneSettingsTest, IncludedFilesAreNotOverwritten) {
  PutScene("include parts.png\n");
  Put(folder_ / "parts.png", "Film { size 9 9 }");
  EXPECT_EQ(Candela({"render", "scene.txt", "-o", "parts.png"}).err,
            "candela render: error: 'parts.png' is a part of the scene, which would be "
            "overwritten\n");
  EXPECT_EQ(Bytes("parts.png"), "Film { size 9 9 }");
}

// Two of the four materials are wrong and worn, one of them twice; one that nobody wears is no
// harm.
TEST_F(SceneSettingsTest, PathsPlaceTheMaterialsThatTheyDoNotKnow) {
  std::string nodes;
  for (const char* worn : {"3", "0", "1", "3"}) {
    nodes += fmt::format(
        "Node {{ Component<Material> {{ index {} }} Component<Object> {{ type sphere radius 1 }} "
        "}}\n",
        worn);
  }
  const auto put = [&](const std::string& settings) {
    Put(folder_ / "scene.txt", settings +
                                   "\nCamera { center 0 1 8 direction 0 0 -1 up 0 1 0 fov 40 }\n"
                                   "Materials {\n"
                                   "  Material { specular 0.5 0.5 0.5 }\n"
                                   "  Material { }\n"
                                   "  Material { specular 1 1 1 }\n"
                                   "  Material { specular 0.1 0.1 0.1 } }\nScene {\n" +
                                   nodes + "}");
  };
  const auto lines = [](std::string_view integrator) {
    std::string all;
    for (const char* place : {"4:3", "7:3"}) {
      all += fmt::format(
          "scene.txt:{}: error: the material has a Phong highlight, or reflects more light than it "
          "gets, which the integrator '{}' does not know; 'whitted' does, and so does it "
          "'normalised'\n",
          place, integrator);
    }
    return all;
  };
  put("");
  for (const char* integrator : {"path", "light_trace"}) {
    const ProgramEnd end =
        Candela({"render", "scene.txt", "-o", "o.png", "--integrator", integrator});
    EXPECT_EQ(end.status, 1);
    EXPECT_EQ(end.err, lines(integrator));
  }
  EXPECT_EQ(Candela({"check", "scene.txt"}).status, 0);

  put("Render { integrator path }");
  const ProgramEnd checked = Candela({"check", "scene.txt"});
  EXPECT_EQ(checked.status, 1);
  EXPECT_EQ(checked.err, lines("path"));
}

}  // namespace
}  // namespace candela::testing_support
