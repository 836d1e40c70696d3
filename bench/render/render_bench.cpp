// Measures path tracing against Cycles: error times CPU time in three scenes. Prints tables.

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "driver/arg_parser.h"
#include "driver/console.h"
#include "driver/picture_files.h"
#include "image/image_file.h"
#include "picture_error.h"
#include "scene_files.h"
#include "support/document_table.h"
#include "support/measured_run.h"
#include "support/run_bench.h"

namespace candela {
namespace {

namespace fs = std::filesystem;

constexpr const char* kName = "render_bench";
constexpr int kBounces = 16;

/// What error times CPU seconds of Cycles 3.4 was, and what is asked of us.
struct SceneTarget {
  std::string name;
  double at_least, goal;                  ///< Error times CPU seconds.
  double samples_at_least, samples_goal;  ///< Millions of samples in a CPU second.
};
const SceneTarget kScenes[] = {
    {"cornell", 0.077, 0.039, 1.0, 1.5},
    {"glass", 0.039, 0.020, 1.1, 1.7},
    {"statue", 0.044, 0.022, 0.6, 0.85},
};

struct BenchOptions {
  int side = 512, samples = 64, reference_samples = 1024, threads = 2, runs = 3;
  bool only_ours = false;
  std::vector<std::string> scenes;
  fs::path folder = fs::temp_directory_path() / "candela-render-bench";
  std::optional<fs::path> json;
  bool update = false;
};

/// One program that renders a scene of the folder.
struct Renderer {
  std::string name;
  fs::path program;
  std::vector<std::string> (*arguments)(const BenchOptions& options, const std::string& scene,
                                        int samples, int seed, const fs::path& output);
};

std::vector<std::string> OurArguments(const BenchOptions& options, const std::string& scene,
                                      int samples, int seed, const fs::path& output) {
  const std::string side = std::to_string(options.side);
  return {"render",
          (options.folder / (scene + ".txt")).string(),
          "-o",
          output.string(),
          "--size",
          side,
          side,
          "--integrator",
          "path",
          "--bounces",
          std::to_string(kBounces),
          "--samples",
          std::to_string(samples),
          "--seed",
          std::to_string(seed),
          "--threads",
          std::to_string(options.threads),
          "--quiet"};
}

std::vector<std::string> CyclesArguments(const BenchOptions& options, const std::string& scene,
                                         int samples, int seed, const fs::path& output) {
  return {"-b",
          "--factory-startup",
          "-noaudio",
          "-P",
          CYCLES_SCRIPT,
          "--",
          scene,
          options.folder.string(),
          std::to_string(options.side),
          std::to_string(samples),
          std::to_string(seed),
          std::to_string(options.threads),
          output.string()};
}

/// What one program gives for one scene.
struct Measurement {
  double error = 0;           ///< Relative, squared.
  double render_seconds = 0;  ///< CPU time of all samples.
  double setup_seconds = 0;   ///< CPU time of everything else.
  double peak_megabytes = 0;
  Image reference;

  double ErrorTimesSeconds() const { return error * render_seconds; }
};

double Median(std::vector<double> values) {
  std::ranges::sort(values);
  return values[values.size() / 2];
}

class RenderBench {
 public:
  RenderBench(const BenchOptions& options, const Renderer& renderer, std::string scene)
      : options_(options), renderer_(renderer), scene_(std::move(scene)) {}

  Result<Measurement> Run() {
    Measurement result;
    MeasuredRun run;
    auto reference = Render(options_.reference_samples, kReferenceSeed, &run);
    if (!reference) return reference.error();
    result.reference = *std::move(reference);
    std::vector<double> errors, seconds, setups;
    for (int i = 0; i < options_.runs; ++i) {
      MeasuredRun one, all;
      if (auto done = Render(1, i, &one); !done) return done.error();
      const auto picture = Render(options_.samples, i, &all);
      if (!picture) return picture.error();
      // A program that does everything but the samples takes the rest of the shorter run.
      const double per_sample =
          (all.cpu_seconds - one.cpu_seconds) / std::max(1, options_.samples - 1);
      errors.push_back(TrimmedRelativeError(*picture, result.reference));
      seconds.push_back(per_sample * options_.samples);
      setups.push_back(one.cpu_seconds - per_sample);
      result.peak_megabytes = static_cast<double>(all.peak_bytes) / 1e6;
    }
    result.error = Median(errors);
    result.render_seconds = Median(seconds);
    result.setup_seconds = Median(setups);
    return result;
  }

 private:
  static constexpr int kReferenceSeed = 1000;

  Result<Image> Render(int samples, int seed, MeasuredRun* run) const {
    const fs::path output = options_.folder / (renderer_.name + "-" + scene_ + ".exr");
    std::error_code ignored;
    fs::remove(output, ignored);
    const auto measured =
        Measure(renderer_.program, renderer_.arguments(options_, scene_, samples, seed, output));
    if (!measured) return measured.error();
    *run = *measured;
    return ReadImage(output);
  }

  const BenchOptions& options_;
  const Renderer& renderer_;
  const std::string scene_;
};

/// Both programs and one scene.
struct Row {
  SceneTarget target;
  Measurement ours;
  std::optional<Measurement> theirs;
  double region_difference = 0;
};

double MillionSamples(const BenchOptions& options) {
  return 1e-6 * options.side * options.side * options.samples;
}

std::string Table(const BenchOptions& options, const std::vector<Row>& rows) {
  std::string text = fmt::format(
      "{0} x {0} pixels, {1} samples, {2} bounces, {3} threads; the median of {4} runs. The error "
      "is that to a picture of {5} samples of the same program.\n\n"
      "| scene | program | error x CPU s | at least | goal | error | samples, CPU s | Msamples per "
      "CPU s | at least | goal | set-up, CPU s | peak MB |\n"
      "|---|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|\n",
      options.side, options.samples, kBounces, options.threads, options.runs,
      options.reference_samples);
  const auto add = [&](const Row& row, const char* program, const Measurement& m) {
    const SceneTarget& t = row.target;
    text += fmt::format(
        "| {} | {} | {:.4f} | {} | {} | {:.5f} | {:.2f} | {:.2f} | {} | {} | {:.2f} | {:.0f} |\n",
        t.name, program, m.ErrorTimesSeconds(), t.at_least, t.goal, m.error, m.render_seconds,
        MillionSamples(options) / m.render_seconds, t.samples_at_least, t.samples_goal,
        m.setup_seconds, m.peak_megabytes);
  };
  for (const Row& row : rows) {
    add(row, "Candela", row.ours);
    if (row.theirs) add(row, "Cycles", *row.theirs);
  }
  if (options.only_ours) return text;
  text +=
      "\n| scene | Candela's error x time, to Cycles' | samples per second, to Cycles' | means of "
      "64 "
      "regions differ by at most |\n|---|---:|---:|---:|\n";
  for (const Row& row : rows) {
    text += fmt::format("| {} | {:.2f} | {:.2f} | {:.2f} % |\n", row.target.name,
                        row.ours.ErrorTimesSeconds() / row.theirs->ErrorTimesSeconds(),
                        row.theirs->render_seconds / row.ours.render_seconds,
                        100 * row.region_difference);
  }
  return text;
}

nlohmann::ordered_json ToJson(const Measurement& m) {
  return {{"error", m.error},
          {"render_cpu_seconds", m.render_seconds},
          {"setup_cpu_seconds", m.setup_seconds},
          {"peak_megabytes", m.peak_megabytes}};
}

std::string Json(const BenchOptions& options, const std::vector<Row>& rows) {
  nlohmann::ordered_json all = {{"side", options.side}, {"samples", options.samples}};
  for (const Row& row : rows) {
    nlohmann::ordered_json one = {{"scene", row.target.name}, {"candela", ToJson(row.ours)}};
    if (row.theirs) {
      one["cycles"] = ToJson(*row.theirs);
      one["region_difference"] = row.region_difference;
    }
    all["scenes"].push_back(one);
  }
  return all.dump(2) + "\n";
}

Result<void> Run(const BenchOptions& options) {
  if (auto written = WriteSceneFiles(BENCH_SCENES, options.folder); !written) return written;
  const Renderer ours{"candela", CANDELA_PROGRAM, OurArguments};
  const Renderer cycles{"cycles", "/usr/bin/blender", CyclesArguments};
  std::vector<Row> rows;
  for (const SceneTarget& target : kScenes) {
    if (!options.scenes.empty() &&
        std::ranges::find(options.scenes, target.name) == options.scenes.end()) {
      continue;
    }
    fmt::print(stderr, "{}\n", target.name);
    Row row{target, {}, {}, 0};
    auto measured = RenderBench(options, ours, target.name).Run();
    if (!measured) return measured.error();
    row.ours = *std::move(measured);
    if (!options.only_ours) {
      auto theirs = RenderBench(options, cycles, target.name).Run();
      if (!theirs) return theirs.error();
      row.theirs = *std::move(theirs);
      row.region_difference = LargestRegionDifference(row.ours.reference, row.theirs->reference);
    }
    rows.push_back(std::move(row));
  }
  const std::string table = Table(options, rows);
  if (auto printed = WriteResult(table); !printed) return printed;
  if (options.json) {
    if (auto written = WriteOutput(*options.json, Json(options, rows)); !written) return written;
  }
  return options.update ? UpdateDocument("docs/performance.md", "render bench", table)
                        : Result<void>();
}

ArgValue SceneName(std::vector<std::string>* names) {
  static const std::vector<std::string_view> kChoices = {kScenes[0].name, kScenes[1].name,
                                                         kScenes[2].name};
  const auto store = [=](std::string_view word) {
    if (std::ranges::find(kChoices, word) == kChoices.end()) return false;
    names->emplace_back(word);
    return true;
  };
  return {"SCENE", "'cornell', 'glass' or 'statue'", store, kChoices};
}

int Main(std::span<const char* const> words) {
  BenchOptions options;
  ArgParser parser(kName, "Measures path tracing against Cycles (Debian's blender).",
                   ArgStyle::kGnu);
  parser.OptionalList(SceneName(&options.scenes), "what is rendered; the default is all");
  parser.Group("What is measured");
  parser.Flag("only-ours", &options.only_ours, "without Cycles");
  parser.Option("size", {Whole("N", &options.side, 16, 4096)},
                "side of the pictures in pixels; the default is 512");
  parser.Option("samples", {Whole("N", &options.samples, 2, 65536)},
                "of each pixel; the default is 64");
  parser.Option("reference", {Whole("N", &options.reference_samples, 2, 1 << 20)},
                "samples of the pictures that errors are measured to; the default is 1024");
  parser.Option("runs", {Whole("N", &options.runs, 1, 100)}, "the default is 3");
  parser.Option("threads", {Whole("N", &options.threads, 1, 256)}, "the default is 2");
  parser.Option("folder", {File("FOLDER", &options.folder)},
                "where scenes and pictures go; the default is a folder for temporary files");
  parser.Group("Results");
  parser.Option("json", {File("FILE", &options.json)}, "write everything there");
  parser.Flag("update", &options.update,
              "put the tables into docs/performance.md; in the root of the project");
  return RunBench(parser, words, [&]() -> Result<void> {
    if (options.update && (options.only_ours || !options.scenes.empty())) {
      return Error{ErrorCode::kUsage, "--update needs all scenes and both programs"};
    }
    return Run(options);
  });
}

}  // namespace
}  // namespace candela

int main(int argc, char** argv) {
  return candela::Main(candela::WordsOf(argc, argv));
}
