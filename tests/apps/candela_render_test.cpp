// candela render, run as a user does.

#include <nlohmann/json.hpp>

#include "base/isa.h"
#include "image/tone_curve.h"
#include "kernel/accelerator_kind.h"
#include "tests/apps/programs.h"

namespace candela::testing_support {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class CandelaRenderTest : public ProgramTest {
 protected:
  /// Renders 40 x 30 pixels of the scene with more arguments.
  ProgramEnd Render(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), {"render", "scene.txt", "--size", "40", "30"});
    return Candela(arguments);
  }
  /// The fingerprint of such a picture.
  size_t Rendered(const std::vector<std::string>& arguments) const {
    std::vector<std::string> all = arguments;
    all.insert(all.end(), {"-o", "o.exr"});
    const ProgramEnd end = Render(all);
    EXPECT_EQ(end.status, 0) << end.err;
    EXPECT_EQ(end.out, "");
    return PixelFingerprint("o.exr");
  }
  /// Of what it shows: the file also tells how it was made.
  size_t PixelFingerprint(const std::string& name) const {
    const Image picture = Picture(name);
    const auto bytes = std::as_bytes(picture.Samples());
    return std::hash<std::string_view>()(
        {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  }
  /// Lit by the background alone: without highlights, which paths do not know.
  void UseDiffuseScene(const std::string& floor = "plane normal 0 1 0 offset -1") const {
    Put(folder_ / "scene.txt",
        std::string("Camera { center 0 1 8 direction 0 0 -1 up 0 1 0 fov 40 }\n") +
            "Background { color 1 0.5 0.25 ambient_light 0 0 0 }\n"
            "Materials { Material { diffuse 0.8 0.8 0.8 } }\n"
            "Scene { Node { Component<Material> { index 0 } Component<Object> { type sphere radius "
            "1 } "
            "}\n"
            "  Node { Component<Material> { index 0 }\n"
            "    Component<Object> { type " +
            floor + " } } }\n");
  }
  void ExpectUsageError(const std::vector<std::string>& arguments, const std::string& message) {
    ExpectRefusal(Render(arguments), 2, "candela render: error: " + message);
  }
};

TEST_F(CandelaRenderTest, UsualSizeIsEightHundred) {
  EXPECT_EQ(Candela({"render", "scene.txt", "-o", "o.png"}).status, 0);
  EXPECT_EQ(Picture("o.png").Width(), 800);
  EXPECT_EQ(Picture("o.png").Height(), 800);
}

// With the same flags the two programs are one.
TEST_F(CandelaRenderTest, GivesThePictureOfTheCourseProgram) {
  const std::vector<std::string> course[] = {
      {"-bounces", "3", "-shadows"}, {"-jitter"}, {"-jitter", "-filter"}, {"-stretch"}};
  const std::vector<std::string> modern[] = {
      {"--bounces=3", "--shadows"}, {"--jitter"}, {"--jitter", "--filter", "tent"}, {"--stretch"}};
  for (size_t i = 0; i < std::size(course); ++i) {
    std::vector<std::string> arguments = course[i];
    arguments.insert(arguments.end(),
                     {"-input", "scene.txt", "-size", "40", "30", "-output", "course.exr"});
    EXPECT_EQ(Assignment4(arguments).status, 0);
    EXPECT_EQ(Rendered(modern[i]), PixelFingerprint("course.exr")) << i;
  }
}

TEST_F(CandelaRenderTest, SamplesFiltersAndSeedsShow) {
  const std::vector<size_t> pictures = {Rendered({}),
                                        Rendered({"--samples", "4"}),
                                        Rendered({"--samples", "4", "--seed", "1"}),
                                        Rendered({"--samples", "4", "--filter", "tent"}),
                                        Rendered({"--samples", "4", "--filter", "gaussian"}),
                                        Rendered({"--samples", "4", "--filter", "mitchell"}),
                                        Rendered({"--samples", "4", "--sampler", "stratified"}),
                                        Rendered({"--samples", "4", "--sampler", "independent"}),
                                        Rendered({"--samples", "4", "--sampler", "blue_noise"}),
                                        Rendered({"--pixel-grid", "centres"})};
  for (size_t i = 0; i < pictures.size(); ++i) {
    for (size_t j = 0; j < i; ++j) EXPECT_NE(pictures[i], pictures[j]) << i << " and " << j;
  }
  EXPECT_EQ(Rendered({"--samples", "1"}), pictures[0]);
  EXPECT_EQ(Rendered({"--samples", "4", "--sampler", "sobol"}), pictures[1]);
  EXPECT_EQ(Rendered({"--samples", "4", "--filter", "box"}), pictures[1]);
  EXPECT_EQ(Rendered({"--filter", "tent"}), Rendered({"--filter", "tent", "--samples", "16"}));
}

TEST_F(CandelaRenderTest, PathsHaveUsualValuesOfTheirOwn) {
  UseDiffuseScene();
  const size_t usual = Rendered({"--integrator", "path"});
  EXPECT_EQ(usual, Rendered({"--integrator", "path", "--samples", "64", "--pixel-grid", "centres",
                             "--filter", "box", "--bounces", "2147483647"}));
  EXPECT_NE(usual, Rendered({"--integrator", "path", "--samples", "32"}));
  EXPECT_NE(usual, Rendered({"--integrator", "path", "--pixel-grid", "corners"}));
  EXPECT_NE(usual, Rendered({"--integrator", "path", "--bounces", "1"}));
  EXPECT_NE(usual, Rendered({"--integrator", "path", "--seed", "1"}));
  EXPECT_NE(usual, Rendered({"--pixel-grid", "centres", "--samples", "64"}));
}

TEST_F(CandelaRenderTest, LightPathsHaveTheUsualValuesOfPaths) {
  UseDiffuseScene();
  ExpectRefusal(Render({"-o", "o.exr", "--integrator", "light_trace"}), 1,
                "scene.txt:6:30: error: the plane has no end, so the integrator "
                "'light_trace' cannot send all of the light from the sky to it; 'path' can, and so "
                "can both with a rectangle");
  UseDiffuseScene("rectangle width 9 height 9");
  const size_t usual = Rendered({"--integrator", "light_trace"});
  EXPECT_EQ(usual, Rendered({"--integrator", "light_trace", "--samples", "64", "--pixel-grid",
                             "centres", "--filter", "box", "--bounces", "2147483647"}));
  for (const char* filter : {"tent", "gaussian", "mitchell"}) {
    EXPECT_NE(usual, Rendered({"--integrator", "light_trace", "--filter", filter}));
  }
  EXPECT_NE(usual, Rendered({"--integrator", "light_trace", "--bounces", "1"}));
  EXPECT_NE(usual, Rendered({"--integrator", "light_trace", "--seed", "1"}));
  EXPECT_NE(usual, Rendered({"--integrator", "path"}));
}

TEST_F(CandelaRenderTest, LightPathsRefuseWhatBelongsToSamples) {
  UseDiffuseScene("rectangle width 9 height 9");
  const std::vector<std::string> usual = {"-o", "o.exr", "--integrator", "light_trace"};
  const auto with = [&](std::vector<std::string> more) {
    more.insert(more.begin(), usual.begin(), usual.end());
    return more;
  };
  ExpectUsageError(with({"--aov", "all"}), "--aov: the integrator 'light_trace' has no layers");
  ExpectUsageError(with({"--checkpoint", "c.bin"}),
                   "--checkpoint: what 'light_trace' has done cannot be kept");
  ExpectUsageError(with({"--clamp", "5"}),
                   "--clamp: what light paths of 'light_trace' bring has no samples to clamp");
}

TEST_F(CandelaRenderTest, ThreadsChangeNothing) {
  const size_t one = Rendered({"--threads", "1", "--samples", "4", "--bounces", "2"});
  EXPECT_EQ(Rendered({"--threads", "2", "--samples", "4", "--bounces", "2"}), one);
  EXPECT_EQ(Rendered({"--threads", "7", "--samples", "4", "--bounces", "2"}), one);
}

TEST_F(CandelaRenderTest, ThePictureDoesNotDependOnTheInstructionSet) {
  const size_t usual = Rendered({"--bounces", "2"});
  for (const Isa isa : {Isa::kScalar, Isa::kAvx2, Isa::kAvx512}) {
    const std::string name(IsaName(isa));
    if (IsSupported(isa)) {
      EXPECT_EQ(Rendered({"--bounces", "2", "--isa", name}), usual) << name;
    } else {
      ExpectUsageError({"-o", "o.png", "--isa", name},
                       "--isa: this processor does not know " + name);
    }
  }
}

TEST_F(CandelaRenderTest, AnyAcceleratorGivesTheSamePicture) {
  const size_t usual = Rendered({"--bounces", "2"});
  for (const AcceleratorEntry& entry : Accelerators()) {
    const std::string name(entry.name);
    EXPECT_EQ(Rendered({"--bounces", "2", "--accelerator", name}), usual) << name;
    const ProgramEnd end = Render({"-o", "o.exr", "--accelerator", name, "--stats"});
    EXPECT_THAT(end.err, HasSubstr(" threads, " + name + ", "));
  }
}

TEST_F(CandelaRenderTest, ACropIsThatPartOfTheWhole) {
  EXPECT_EQ(Render({"-o", "whole.exr", "--samples", "4"}).status, 0);
  EXPECT_EQ(Render({"-o", "part.exr", "--samples", "4", "--crop", "10", "5", "31", "30"}).status,
            0);
  const Image whole = Picture("whole.exr"), part = Picture("part.exr");
  ASSERT_EQ(part.Width(), 21);
  ASSERT_EQ(part.Height(), 25);
  for (int y = 0; y < part.Height(); ++y) {
    for (int x = 0; x < part.Width(); ++x) {
      for (int c = 0; c < 3; ++c) ASSERT_EQ(part.At(x, y, c), whole.At(x + 10, y + 5, c));
    }
  }
}

TEST_F(CandelaRenderTest, CropsMapsToo) {
  EXPECT_EQ(Render({"--normals", "n.pfm", "--depth", "0", "9", "d.png"}).status, 0);
  EXPECT_EQ(Render({"--normals", "m.pfm", "--crop", "3", "4", "5", "6"}).status, 0);
  EXPECT_EQ(Picture("m.pfm").At(0, 0, 1), Picture("n.pfm").At(3, 4, 1));
  EXPECT_EQ(Picture("m.pfm").Width(), 2);
}

TEST_F(CandelaRenderTest, PngsHaveEightOrSixteenBits) {
  // The bit depth is the byte after the sizes in the first chunk.
  constexpr size_t kDepthByte = 24;
  EXPECT_EQ(Render({"-o", "o.png"}).status, 0);
  EXPECT_EQ(Bytes("o.png")[kDepthByte], 8);
  EXPECT_EQ(Render({"-o", "o.png", "--png-bits", "16"}).status, 0);
  EXPECT_EQ(Bytes("o.png")[kDepthByte], 16);
}

TEST_F(CandelaRenderTest, PngsShowLightThroughACurve) {
  const auto value = [&](const std::vector<std::string>& options) {
    std::vector<std::string> words = {"-o", "o.png"};
    words.insert(words.end(), options.begin(), options.end());
    EXPECT_EQ(Render(words).status, 0);
    return Picture("o.png").At(20, 15, 0);
  };
  const float plain = value({});
  ASSERT_GT(plain, 0.05f);
  ASSERT_LT(plain, 0.95f);
  EXPECT_EQ(value({"--tonemap", "none"}), plain);
  EXPECT_NEAR(value({"--tonemap", "srgb"}), SrgbFromLinear(plain), 0.02f);
  EXPECT_LT(value({"--exposure", "-1"}), plain);
  EXPECT_EQ(value({}), plain);
  const size_t usual = Fingerprint("o.png");
  EXPECT_EQ(value({"--exposure", "0"}), plain);
  EXPECT_EQ(Fingerprint("o.png"), usual) << "the default is no other rounding";
  EXPECT_GT(value({"--tonemap", "agx", "--exposure", "2"}), value({"--tonemap", "agx"}));

  // What path tracing gives is light, and shown as light.
  UseDiffuseScene();
  const float light = value({"--integrator", "path", "--samples", "4", "--tonemap", "none"});
  EXPECT_NEAR(value({"--integrator", "path", "--samples", "4"}), SrgbFromLinear(light), 0.02f);
}

TEST_F(CandelaRenderTest, ExplainsAPixelOnStdout) {
  const ProgramEnd end = Render({"--pixel", "20", "15", "--bounces", "2"});
  EXPECT_EQ(end.status, 0);
  EXPECT_EQ(end.err, "");
  EXPECT_THAT(end.out, HasSubstr("hits the sphere of line 11"));
  EXPECT_THAT(end.out, HasSubstr("reflects"));
  EXPECT_THAT(folder_.Names(), ElementsAre("scene.txt"));
  UseDiffuseScene();
  ExpectRefusal(Render({"--pixel", "20", "15", "--integrator", "path"}), 2,
                "candela render: error: the integrator 'path' cannot explain a pixel");
}

TEST_F(CandelaRenderTest, StatisticsGoToStderrAndToAFile) {
  const ProgramEnd end = Render({"-o", "o.png", "--stats", "--stats-json", "s.json", "--threads",
                                 "2", "--shadows", "--bounces", "1"});
  EXPECT_EQ(end.status, 0);
  EXPECT_EQ(end.out, "");
  EXPECT_THAT(end.err, HasSubstr("scene.txt: 40 x 30 pixels, 1 samples each, whitted, 2 threads"));
  const auto json = nlohmann::json::parse(Bytes("s.json"));
  EXPECT_EQ(json["rays"]["camera"], 1200);
  EXPECT_GT(json["rays"]["reflection"], 0);
  EXPECT_GT(json["rays"]["shadow"], 0);
  EXPECT_GT(json["peak_bytes"], 0);
  EXPECT_GT(json["seconds"]["render"], 0);
  EXPECT_THAT(folder_.Names(), ElementsAre("o.png", "s.json", "scene.txt"));
}

TEST_F(CandelaRenderTest, RefusesAWrongCommandLine) {
  ExpectRefusal(Candela({"render", "-o", "o.png"}), 2, "candela render: error: SCENE is missing");
  ExpectUsageError({}, "nothing to do: give --output FILE, --normals FILE or --depth MIN MAX FILE");
  ExpectUsageError({"-o"}, "--output: expects FILE, found nothing");
  ExpectUsageError({"-o", "o.png", "--sampels", "4"},
                   "unknown option '--sampels' (did you mean '--samples'?)");
  ExpectUsageError({"-o", "o.png", "second.txt"},
                   "unexpected argument 'second.txt' after --output "
                   "FILE");
  ExpectUsageError({"-o", "o.png", "--filter"}, "--filter: expects NAME, found nothing");
  ExpectUsageError(
      {"-o", "o.png", "--filter", "gausian"},
      "--filter: expects 'box', 'tent', 'gaussian', 'blackman_harris' or 'mitchell', found "
      "'gausian' (did you mean 'gaussian'?)");
  ExpectUsageError(
      {"-o", "o.png", "--integrator", "wihtted"},
      "--integrator: expects 'whitted', 'path', 'light_trace', 'direct', 'ambient_occlusion' or "
      "'debug', found 'wihtted' (did you mean 'whitted'?)");
  ExpectUsageError({"-o", "o.png", "--samples", "0"},
                   "--samples: expects a whole number from 1 to 2147483647, found '0'");
  ExpectUsageError({"-o", "o.png", "--accelerator", "octre"},
                   "--accelerator: expects 'bvh', 'grid', 'octree' or 'none', found 'octre' (did "
                   "you mean 'octree'?)");
  ExpectUsageError({"-o", "o.png", "--isa", "mmx"},
                   "--isa: expects 'scalar', 'avx2' or 'avx512', found 'mmx'");
  ExpectUsageError({"-o", "o.png", "--threads", "0"},
                   "--threads: expects a whole number from 1 to 1024, found '0'");
  ExpectUsageError({"-o", "o.png", "--seed", "4294967296"},
                   "--seed: expects a whole number from 0 to 4294967295, found '4294967296'");
  ExpectUsageError({"-o", "o.png", "--png-bits", "12"},
                   "--png-bits: expects '8' or '16', found '12'");
  ExpectUsageError({"-o", "o.png", "--pixel-grid", "centers"},
                   "--pixel-grid: expects 'corners' or 'centres', found 'centers' (did you mean "
                   "'centres'?)");
  EXPECT_THAT(folder_.Names(), ElementsAre("scene.txt"));
}

TEST_F(CandelaRenderTest, RefusesOptionsThatDoNotGoTogether) {
  ExpectUsageError({"-o", "o.exr", "--tonemap", "agx"},
                   "--tonemap is for .png and .jpg files; the others hold the light itself");
  ExpectUsageError({"-o", "o.hdr", "--exposure", "1"},
                   "--exposure is for .png and .jpg files; the others hold the light itself");
  ExpectRefusal(
      Candela({"render", "scene.txt", "-o", "o.jpg", "--size", "65501", "2"}), 2,
      "candela render: error: 'o.jpg': a side of a JPEG picture has at most 65500 pixels");
  ExpectUsageError({"-o", "o.png", "--jitter", "--samples", "4"},
                   "--jitter and --samples: give one of them");
  ExpectUsageError({"-o", "o.png", "--jitter", "--filter", "box"},
                   "--jitter goes with --filter tent only; use --samples with other filters");
  ExpectUsageError({"-o", "o.png", "--crop", "5", "0", "5", "9"},
                   "--crop: X0 has to be less than X1, and Y0 less than Y1");
  ExpectUsageError({"-o", "o.png", "--crop", "5", "0", "41", "9"},
                   "--crop: reaches beyond the picture of 40 x 30 pixels");
  ExpectUsageError({"--pixel", "40", "0"}, "--pixel: lies outside the picture of 40 x 30 pixels");
  ExpectUsageError({"--pixel", "4", "0", "-o", "o.png"},
                   "--pixel renders nothing, so --output cannot be given");
  ExpectUsageError({"--pixel", "4", "0", "--stats"},
                   "--pixel renders nothing, so --stats cannot be given");
  ExpectUsageError({"-o", "o.exr", "--depth", "0", "9", "d.jpg", "--png-bits", "16"},
                   "--png-bits is for .png files, of which none would be written");
  ExpectUsageError({"--normals", "n.png", "--tonemap", "agx"},
                   "--tonemap is for the picture of --output: give both");
  ExpectUsageError({"--normals", "n.png", "--exposure", "3"},
                   "--exposure is for the picture of --output: give both");
  ExpectUsageError({"-o", "a.json", "--stats-json", "a.json"},
                   "--output and --stats-json both write 'a.json'");
  ExpectUsageError({"-o", "o.png", "--stats-json", "scene.txt"},
                   "--stats-json: 'scene.txt' is the scene, which would be overwritten");
}

// What counts is the part that is written, and the size may be the scene's.
TEST_F(CandelaRenderTest, TheSizeOfAJpegIsThatOfTheFile) {
  const ProgramEnd small = Candela({"render", "scene.txt", "-o", "o.jpg", "--size", "70000", "2",
                                    "--crop", "9", "0", "99", "2"});
  EXPECT_EQ(small.status, 0) << small.err;
  EXPECT_EQ(Picture("o.jpg").Width(), 90);
  Put(folder_ / "wide.txt", std::string("Film { size 70000 2 }") + kSmallScene);
  ExpectRefusal(
      Candela({"render", "wide.txt", "-o", "w.jpg"}), 2,
      "candela render: error: 'w.jpg': a side of a JPEG picture has at most 65500 pixels");
}

TEST_F(CandelaRenderTest, AFileOfStatisticsThatCannotBeWrittenIsRefusedFirst) {
  const ProgramEnd end = Render({"-o", "o.png", "--stats-json", "missing/s.json"});
  EXPECT_EQ(end.status, 3);
  EXPECT_THAT(end.err, testing::StartsWith("candela render: error: 'missing/s.json': "));
  EXPECT_THAT(folder_.Names(), ElementsAre("scene.txt"));
}

TEST_F(CandelaRenderTest, RefusesACropThatWouldNotFitButNotASmallPartOfALargePicture) {
  const std::vector<std::string> huge = {"render", "scene.txt",  "-o",        "o.png",
                                         "--size", "2000000000", "2000000000"};
  EXPECT_EQ(Candela(huge).status, 4);
  std::vector<std::string> part = huge;
  part.insert(part.end(), {"--crop", "1000000000", "1000000000", "1000000020", "1000000010"});
  EXPECT_EQ(Candela(part).status, 0);
  EXPECT_EQ(Picture("o.png").Width(), 20);
}

}  // namespace
}  // namespace candela::testing_support
