// The rules of docs/architecture.md section 2 hold in src/ and apps/; and the checker sees
// breaches.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "base/files.h"
#include "tests/layering/layering_rules.h"

namespace candela::layering {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::IsEmpty;

std::vector<fs::path> SourcesBelow(const fs::path& root) {
  std::vector<fs::path> paths;
  for (const auto& entry : fs::recursive_directory_iterator(root)) {
    const fs::path extension = entry.path().extension();
    if (extension == ".h" || extension == ".cpp") paths.push_back(entry.path());
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

TEST(Layering, EveryFolderOfTheSourcesHasItsRow) {
  for (const auto& entry : fs::directory_iterator("src")) {
    if (!entry.is_directory()) continue;
    EXPECT_TRUE(IsKnownFolder(entry.path().filename().string())) << entry.path();
  }
}

TEST(Layering, HoldsInEverySource) {
  size_t count = 0;
  for (const char* root : {"src", "apps"}) {
    for (const fs::path& path : SourcesBelow(root)) {
      const auto source = ReadFile(path);
      ASSERT_TRUE(source) << path;
      EXPECT_THAT(Breaches(path.generic_string(), *source), IsEmpty());
      ++count;
    }
  }
  EXPECT_GE(count, 30u) << "the test looked in the wrong place";
}

TEST(Breaches, IncludesGoDownTheTable) {
  EXPECT_THAT(Breaches("src/render/a.cpp", "#include \"base/result.h\"\n"), IsEmpty());
  EXPECT_THAT(Breaches("src/base/a.h", "#include \"base/check.h\"\n"), IsEmpty());
  EXPECT_THAT(Breaches("apps/candela/main.cpp",
                       "#include \"candela/info.h\"\n#include \"render/render_job.h\"\n"),
              IsEmpty());
  EXPECT_THAT(Breaches("src/math/a.h", "#pragma once\n\n#include \"geometry/ray.h\"\n"),
              ElementsAre("src/math/a.h:3: math/ may not include geometry/"));
  EXPECT_THAT(Breaches("src/integrators/a.cpp", "# include \"film/film.h\""),
              ElementsAre("src/integrators/a.cpp:1: integrators/ may not include film/"));
  EXPECT_THAT(Breaches("src/loaders/obj/a.cpp", "#include \"lights/light.h\""),
              ElementsAre("src/loaders/obj/a.cpp:1: loaders/ may not include lights/"));
  EXPECT_THAT(Breaches("src/base/a.cpp", "#include \"check.h\""),
              ElementsAre("src/base/a.cpp:1: base/ may not include check.h/"));
}

TEST(Breaches, PlatformCodeHasItsPlace) {
  for (const char* line :
       {"#include <unistd.h>", "#include <sys/stat.h>", "#include <windows.h>"}) {
    EXPECT_THAT(Breaches("src/base/posix/a.cpp", line), IsEmpty()) << line;
    EXPECT_THAT(Breaches("src/base/a.cpp", line),
                ElementsAre("src/base/a.cpp:1: platform headers belong in base/posix/"));
  }
  for (const char* line : {"#include <immintrin.h>", "#include <x86intrin.h>"}) {
    EXPECT_THAT(Breaches("src/kernel/simd/avx2.h", line), IsEmpty()) << line;
    EXPECT_THAT(Breaches("src/kernel/traverse.h", line),
                ElementsAre("src/kernel/traverse.h:1: intrinsics belong in kernel/simd/"));
  }
  EXPECT_THAT(
      Breaches("src/base/clock.cpp", "#include <tbb/parallel_for.h>"),
      ElementsAre("src/base/clock.cpp:1: the threading library belongs in base/parallel.cpp"));
}

TEST(Breaches, OnlyProgramsPrintAndExit) {
  for (const char* line : {"std::cout << 1;", "printf(\"x\");", "std::fprintf(stderr, \"x\");",
                           "fmt::print(\"x\");", "std::puts (s);"}) {
    EXPECT_THAT(Breaches("apps/candela/a.cpp", line), IsEmpty()) << line;
    EXPECT_THAT(Breaches("src/film/a.cpp", line),
                ElementsAre("src/film/a.cpp:1: only programs print"))
        << line;
  }
  EXPECT_THAT(Breaches("src/film/a.cpp", "std::exit(1);"),
              ElementsAre("src/film/a.cpp:1: only programs exit"));
  EXPECT_THAT(Breaches("src/film/a.cpp", "std::snprintf(buffer, 9, text); OnExit(1);"), IsEmpty());
}

TEST(Breaches, ElementaryFunctionsComeFromMath) {
  for (const char* line : {"x = std::sin(y);", "x = cosf(y);", "x = pow(x, 2);",
                           "std::atan2(y, x);", "std::hypot(x, y);", "std::log2 (x)"}) {
    EXPECT_THAT(Breaches("src/math/a.cpp", line), IsEmpty()) << line;
    EXPECT_THAT(
        Breaches("src/film/a.cpp", line),
        ElementsAre("src/film/a.cpp:1: libm differs between machines: use math/elementary.h"))
        << line;
  }
  EXPECT_THAT(Breaches("src/film/a.cpp", "std::sqrt(x) + std::abs(y) + Sin(x) + SinDegrees(y);"),
              IsEmpty());
}

TEST(Breaches, DistributionsOfTheStandardLibraryHaveNoPlace) {
  EXPECT_THAT(
      Breaches("src/math/a.cpp", "std::uniform_real_distribution<float> d;"),
      ElementsAre(
          "src/math/a.cpp:1: distributions of the standard library differ between compilers"));
}

TEST(CodeOf, DropsCommentsAndTexts) {
  EXPECT_EQ(CodeOf("a // printf(\nb"), "a \nb");
  EXPECT_EQ(CodeOf("a /* x\ny */ b"), "a \n b");
  EXPECT_EQ(CodeOf("f(\"exit(1) \\\" //\");"), "f(\"\");");
  EXPECT_EQ(CodeOf("g('\"', '\\'', 1'000);"), "g('', '', 1'000);");
  EXPECT_EQ(CodeOf("h(R\"x(\" sin(\n)x\");k"), "h(\n);k");
  EXPECT_EQ(CodeOf("#include \"base/a.h\"  // why\n"), "#include \"base/a.h\"  \n");
}

}  // namespace
}  // namespace candela::layering
