// Which test holds which of the laws that the renderer is held to. Tests say so themselves: the
// comment above one begins with ids, as in "// P12, CF1: ...". docs/testing.md shows them as a
// table.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <map>
#include <regex>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "tests/docs/markdown.h"
#include "tests/support/generated_part.h"

namespace candela::docs {
namespace {

namespace fs = std::filesystem;

struct Law {
  const char* id;
  const char* claim;
};

constexpr Law kLaws[] = {
    {"P1", "samples follow the density that is said of them (chi-square)"},
    {"P2", "sample, density and value agree; densities integrate to 1"},
    {"P3", "sampling can be inverted"},
    {"P4", "what absorbs nothing is invisible in a furnace"},
    {"P5", "nothing reflects more than it gets; light may go both ways"},
    {"P6", "visible facets of a rough surface cover it"},
    {"P7", "all ways to solve the same transport have the same mean"},
    {"P9", "roulette, choice of lights and weights change the noise, not the mean"},
    {"P10", "noise falls as fast as the sampler promises"},
    {"P11", "intervals by the error that is told hold the truth"},
    {"P12", "limits of depth give partial sums, with roulette and without"},
    {"P13", "lines through solids find volume, surface and mean chord"},
    {"P14", "the camera shows lines, sizes and blur as optics says"},
    {"P15", "edges and fine patterns have the contrast of the filter; nothing is shifted"},
    {"P16", "light gets into files and back as it is, or as the format says"},
    {"P17", "a picture does not depend on where its scene stands or how it is described"},
    {"P18", "the course's scenes look as the course's reference shows them"},
    {"CF1", "glowing room: Le / (1 - rho)"},
    {"CF2", "point light in a sphere: (rho / pi) I / r^2 / (1 - rho)"},
    {"CF3", "point light over a plane: I cos / d^2"},
    {"CF4", "the same in the course's model"},
    {"CF5", "sphere light above the horizon: pi L (R / d)^2 cos"},
    {"CF6", "sphere light cut by the horizon"},
    {"CF7", "parallel disk light"},
    {"CF8", "parallel rectangle light"},
    {"CF9", "polygon light: Lambert's sum over edges"},
    {"CF10", "sky beside a wall: pi L (1 + cos) / 2"},
    {"CF11", "overcast sky: 7 pi L / 9"},
    {"CF12", "form factors of squares, disks and a cube"},
    {"CF13", "two parallel planes: Le / (1 - r1 r2)"},
    {"CF14", "integrating sphere: F / (pi A) rho / (1 - rho (1 - f))"},
    {"CF15", "full diffuse ball: 2/3 of a flat disk"},
    {"CF16", "Fresnel's reflectance of glass, water, diamond"},
    {"CF17", "Brewster's and the critical angle"},
    {"CF18", "a metal head-on"},
    {"CF19", "pane with all inner bounces"},
    {"CF20", "shift by a pane, depth in water"},
    {"CF21", "deviation by a prism, by the colour of the light"},
    {"CF22", "angles of the first and the second rainbow"},
    {"CF24", "silhouette of a sphere"},
    {"CF25", "blur disk of a lens"},
    {"CF26", "contrast of filters at a quarter of a cycle per pixel"},
    {"CF27", "the sRGB curve; the course's bytes"},
    {"CF28", "Beer's law, in even and in linear fog"},
    {"CF32", "density and masking of GGX"},
    {"CF33", "normalised Phong lobe: albedo ks"},
    {"CF35", "penumbra of a straight edge"},
    {"CF36", "black body: Planck's law, Wien's peak"},
    {"CF37", "mean chord: 4 V / S"},
    {"CF38", "albedo of a rough mirror after one bounce"},
};

struct Place {
  std::string file;  ///< Below `tests`.
  std::string test;  ///< "Suite.Name".
};

/// The tests of a file by the ids in the first line of the comments above them.
void AddTestsOf(const fs::path& path, std::map<std::string, std::vector<Place>>* tests) {
  static const std::regex kTest(R"(TEST(?:_P|_F)?\((\w+), (\w+)\).*)");
  static const std::regex kIds(R"(// ((?:(?:P|CF)\d+(?:, )?)+)(?:\b.*)?)");
  std::istringstream lines(ReadDocument(path));
  std::string first;  // Of the comment in work.
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("//")) {
      if (first.empty()) first = line;
      continue;
    }
    std::smatch test, ids;
    if (std::regex_match(line, test, kTest) && std::regex_match(first, ids, kIds)) {
      std::istringstream words(ids[1]);
      for (std::string id; words >> id;) {
        if (id.back() == ',') id.pop_back();
        const std::string file = fs::relative(path, "tests").generic_string();
        (*tests)[id].push_back({file, test[1].str() + "." + test[2].str()});
      }
    }
    first.clear();
  }
}

std::map<std::string, std::vector<Place>> TestsById() {
  std::vector<fs::path> paths;
  for (const auto& entry : fs::recursive_directory_iterator("tests")) {
    if (entry.path().string().ends_with("_test.cpp")) paths.push_back(entry.path());
  }
  std::sort(paths.begin(), paths.end());
  std::map<std::string, std::vector<Place>> tests;
  for (const fs::path& path : paths) AddTestsOf(path, &tests);
  return tests;
}

TEST(PhysicalTests, EveryLawIsHeldByATest) {
  const auto tests = TestsById();
  for (const Law& law : kLaws) {
    EXPECT_TRUE(tests.contains(law.id)) << law.id << ": " << law.claim;
  }
}

TEST(PhysicalTests, NameNoLawThatIsNone) {
  for (const auto& named : TestsById()) {
    const bool is_known = std::any_of(std::begin(kLaws), std::end(kLaws),
                                      [&](const Law& law) { return law.id == named.first; });
    const auto& place = named.second[0];
    EXPECT_TRUE(is_known) << place.file << ", " << place.test << ": " << named.first;
  }
}

// With CANDELA_UPDATE=1 the table is written instead.
TEST(PhysicalTests, StandInTheDocumentWithTheirLaws) {
  const auto tests = TestsById();
  std::string table = "| | Law | Tests |\n|---|---|---|\n";
  for (const Law& law : kLaws) {
    const auto places = tests.find(law.id);
    if (places == tests.end()) continue;
    table += fmt::format("| {} | {} | ", law.id, law.claim);
    std::string file;
    for (const Place& place : places->second) {
      if (place.file != file) {
        table +=
            fmt::format("{}[{}](../tests/{}): ", file.empty() ? "" : "; ", place.file, place.file);
      } else {
        table += ", ";
      }
      table += place.test;
      file = place.file;
    }
    table += " |\n";
  }
  testing_support::ExpectGeneratedPart("docs/testing.md", "physical tests", table);
}

}  // namespace
}  // namespace candela::docs
