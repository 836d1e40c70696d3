// Times the course's program as a user sees it: the seven scenes at 800 x 800, each run a process
// of its own from its start to its end, with loading, rendering, and the PNG file. Prints one
// table.

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "driver/arg_parser.h"
#include "driver/console.h"
#include "driver/picture_files.h"
#include "support/document_table.h"
#include "support/measured_run.h"
#include "support/run_bench.h"
#include "tests/support/course_folder.h"

namespace candela {
namespace {

namespace fs = std::filesystem;

constexpr const char* kName = "course_bench";

struct BenchOptions {
  int runs = 7;
  int side = 800;
  fs::path folder = fs::temp_directory_path() / "candela-course-bench";
  std::optional<fs::path> json;
  bool update = false;
};

/// One row of the table: a command line, and what its runs took.
struct BenchRow {
  std::string name;
  std::vector<std::string> arguments;
  std::vector<MeasuredRun> runs = {};

  /// Sorted.
  std::vector<double> Milliseconds(double MeasuredRun::*seconds) const {
    std::vector<double> all;
    for (const MeasuredRun& run : runs) all.push_back(1000 * run.*seconds);
    std::ranges::sort(all);
    return all;
  }
  double PeakMegabytes() const {
    uint64_t most = 0;
    for (const MeasuredRun& run : runs) most = std::max(most, run.peak_bytes);
    return static_cast<double>(most) / 1e6;
  }
};

double MedianOf(const std::vector<double>& sorted) {
  const size_t middle = sorted.size() / 2;
  return sorted.size() % 2 == 1 ? sorted[middle] : (sorted[middle - 1] + sorted[middle]) / 2;
}

/// The scenes with their course flags. Those with a cube map come again with the course's own
/// faces, four times as large, where its folder is found.
std::vector<BenchRow> MakeRows(const BenchOptions& options) {
  const fs::path own = "assets/assignment4";
  const fs::path course = testing_support::CourseFolder() / "assets";
  std::vector<BenchRow> rows;
  const auto add = [&](std::string name, const fs::path& scene, std::vector<std::string> flags) {
    const std::string side = std::to_string(options.side);
    std::vector<std::string> arguments = {
        "-input",  scene.string(),
        "-output", (options.folder / (name.substr(0, 2) + ".png")).string(),
        "-size",   side,
        side};
    arguments.insert(arguments.end(), flags.begin(), flags.end());
    rows.push_back({std::move(name), std::move(arguments)});
  };
  add("01 plane", own / "scene01_plane.txt", {});
  add("02 cube", own / "scene02_cube.txt", {});
  add("03 sphere", own / "scene03_sphere.txt", {});
  add("04 axes", own / "scene04_axes.txt", {});
  add("05 rabbit", own / "scene05_bunny_200.txt", {});
  const std::vector<std::string> mirror = {"-bounces", "4"};
  const std::vector<std::string> arch = {"-shadows", "-bounces", "4"};
  add("06 rabbit", own / "scene06_bunny_1k.txt", mirror);
  add("07 arch", own / "scene07_arch.txt", arch);
  if (fs::is_directory(course)) {
    add("06, faces of 1024", course / "scene06_bunny_1k.txt", mirror);
    add("07, faces of 1024", course / "scene07_arch.txt", arch);
  }
  return rows;
}

/// Runs every row the same number of times, in turns, so that a disturbance of the machine does not
/// meet one row alone. The first round fills the system's caches and does not count.
Result<void> MeasureAll(const BenchOptions& options, std::vector<BenchRow>* rows) {
  for (int round = 0; round <= options.runs; ++round) {
    for (BenchRow& row : *rows) {
      const Result<MeasuredRun> run = Measure(ASSIGNMENT4_PROGRAM, row.arguments);
      if (!run) return run.error();
      if (round > 0) row.runs.push_back(*run);
    }
  }
  return {};
}

/// In Markdown, since it goes to docs/performance.md.
std::string Table(const std::vector<BenchRow>& rows) {
  std::string text =
      "| scene             | median ms |   min |   max | CPU ms | peak MB |\n"
      "|-------------------|----------:|------:|------:|-------:|--------:|\n";
  for (const BenchRow& row : rows) {
    const std::vector<double> wall = row.Milliseconds(&MeasuredRun::wall_seconds);
    const std::vector<double> cpu = row.Milliseconds(&MeasuredRun::cpu_seconds);
    text +=
        fmt::format("| {:17} | {:9.1f} | {:5.1f} | {:5.1f} | {:6.1f} | {:7.1f} |\n", row.name,
                    MedianOf(wall), wall.front(), wall.back(), MedianOf(cpu), row.PeakMegabytes());
  }
  return text;
}

std::string Json(const BenchOptions& options, const std::vector<BenchRow>& rows) {
  nlohmann::ordered_json scenes = nlohmann::ordered_json::array();
  for (const BenchRow& row : rows) {
    const std::vector<double> wall = row.Milliseconds(&MeasuredRun::wall_seconds);
    scenes.push_back({{"scene", row.name},
                      {"arguments", row.arguments},
                      {"median_ms", MedianOf(wall)},
                      {"wall_ms", wall},
                      {"cpu_ms", row.Milliseconds(&MeasuredRun::cpu_seconds)},
                      {"peak_mb", row.PeakMegabytes()}});
  }
  const nlohmann::ordered_json all = {
      {"side", options.side}, {"runs", options.runs}, {"scenes", scenes}};
  return all.dump(2) + "\n";
}

Result<void> Run(const BenchOptions& options) {
  std::error_code error;
  fs::create_directories(options.folder, error);
  if (error) return Error{ErrorCode::kOutput, options.folder.string() + ": " + error.message()};
  std::vector<BenchRow> rows = MakeRows(options);
  if (auto measured = MeasureAll(options, &rows); !measured) return measured;
  const std::string table = Table(rows);
  if (options.json) {
    if (auto written = WriteOutput(*options.json, Json(options, rows)); !written) return written;
  }
  return Publish("course bench", table, options.update);
}

int Main(std::span<const char* const> words) {
  BenchOptions options;
  ArgParser parser(kName,
                   "Times assignment4 with the seven course scenes. Runs in the root of the "
                   "project.",
                   ArgStyle::kGnu);
  parser.Group("What is measured");
  parser.Option("runs", {Whole("N", &options.runs, 1, 1000)}, "of each scene; the default is 7");
  parser.Option("size", {Whole("N", &options.side, 1, 10000)},
                "side of the pictures in pixels; the default is 800");
  parser.Option("folder", {File("FOLDER", &options.folder)},
                "where the pictures go, on the disk that is measured with them; the default is a "
                "folder for temporary files");
  parser.Group("Results");
  parser.Option("json", {File("FILE", &options.json)}, "write every run there");
  parser.Flag("update", &options.update, "put the table into docs/performance.md");
  return RunBench(parser, words, [&] { return Run(options); });
}

}  // namespace
}  // namespace candela

int main(int argc, char** argv) {
  return candela::Main(candela::WordsOf(argc, argv));
}
