// Measures our kernel against Embree: rays per second in several sets of rays and meshes, the time
// to build trees and their memory, and whether the answers are the same. Prints tables.

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/isa.h"
#include "base/parallel.h"
#include "base/text.h"
#include "driver/arg_parser.h"
#include "driver/console.h"
#include "driver/picture_files.h"
#include "measure.h"
#include "meshes.h"
#include "report.h"
#include "support/document_table.h"
#include "support/run_bench.h"

namespace candela {
namespace {

namespace fs = std::filesystem;

constexpr const char* kName = "kernel_bench";
constexpr const char* kDocument = "docs/performance.md";

struct BenchOptions {
  MeasureOptions measure;
  std::vector<std::string> meshes;
  std::vector<fs::path> files;
  double scale = 1;
  int threads = 2;
  std::string side = "512";
  std::optional<std::string> isa;
  bool no_build = false;
  std::optional<fs::path> json;
  bool update = false;
};

std::vector<std::string_view> MeshNames() {
  std::vector<std::string_view> names;
  for (const SceneEntry& entry : SceneEntries()) names.push_back(entry.name);
  return names;
}

ArgValue MeshName(std::vector<std::string>* names) {
  const std::vector<std::string_view> choices = MeshNames();
  const auto store = [=](std::string_view word) {
    if (std::ranges::find(choices, word) == choices.end()) return false;
    names->emplace_back(word);
    return true;
  };
  return {"MESH", ListOf(choices), store, choices};
}

/// "primary,deep".
ArgValue RaySetNames(std::vector<RaySet>* sets) {
  const auto store = [=](std::string_view word) {
    std::vector<RaySet> found;
    for (bool has_more = true; has_more;) {
      const size_t comma = word.find(',');
      has_more = comma != std::string_view::npos;
      const std::optional<RaySet> set = FindRaySet(word.substr(0, comma));
      if (!set) return false;
      found.push_back(*set);
      if (has_more) word.remove_prefix(comma + 1);
    }
    *sets = found;
    return true;
  };
  return {"SET,...", "'primary', 'diffuse', 'deep' or 'shadow', or several with commas", store};
}

ArgValue Scale(double* scale) {
  return {"S", "a number from 0.001 to 10", [=](std::string_view word) {
            const auto value = ParseDouble(word);
            if (!value || *value < 0.001 || *value > 10) return false;
            *scale = *value;
            return true;
          }};
}

/// The instance scene comes first: its peak of memory is told.
std::vector<SceneEntry> ChosenEntries(const BenchOptions& options) {
  std::vector<SceneEntry> chosen;
  for (const SceneEntry& entry : SceneEntries()) {
    const bool all = options.meshes.empty() && options.files.empty();
    if (all || std::ranges::find(options.meshes, entry.name) != options.meshes.end()) {
      chosen.push_back(entry);
    }
  }
  std::ranges::stable_partition(chosen, [](const SceneEntry& entry) { return !entry.in_summary; });
  return chosen;
}

/// Ours is asked for; Embree has none without vectors, and knows AVX2 under that name.
Result<void> ChooseIsa(const BenchOptions& options, BenchResult* result) {
  if (options.isa) {
    const Isa isa = *FindIsa(*options.isa);
    if (!IsSupported(isa)) {
      return Error{ErrorCode::kUsage, "this processor does not know " + *options.isa};
    }
    ForceIsa(isa);
    if (isa == Isa::kAvx2) result->embree_isa = "avx2";
  }
  result->isa = IsaName(DefaultIsa());
  return {};
}

Result<void> MeasureAll(const BenchOptions& options, BenchResult* result) {
  const ThreadLimit limit(options.threads);
  const EmbreeDevice device(options.threads, result->embree_isa);
  const auto measure = [&](const BenchScene& scene, bool in_summary) -> Result<void> {
    Result<SceneResult> measured = MeasureScene(scene, device, options.measure);
    if (!measured) {
      return Error{measured.error().code, scene.name + ": " + measured.error().message};
    }
    measured->in_summary = in_summary;
    if (!result->scenes.empty()) measured->peak_bytes.reset();
    result->scenes.push_back(*std::move(measured));
    return {};
  };
  for (const SceneEntry& entry : ChosenEntries(options)) {
    fmt::print(stderr, "{}\n", entry.name);
    const BenchScene scene = MakeScene(entry, options.scale);
    if (auto done = measure(scene, entry.in_summary); !done) return done;
  }
  for (const fs::path& file : options.files) {
    const Result<BenchScene> scene = ReadScene(file);
    if (!scene) return scene.error();
    if (auto done = measure(*scene, true); !done) return done;
  }
  return {};
}

/// Finds out what cannot work before the long part.
Result<void> CheckFiles(const BenchOptions& options) {
  for (const fs::path& file : options.files) {
    std::error_code error;
    if (!fs::is_regular_file(file, error)) {
      return Error{ErrorCode::kInput, file.string() + ": no such file"};
    }
  }
  if (options.json) {
    if (auto writable = CheckOutput(*options.json); !writable) return writable;
  }
  return options.update ? CheckOutput(kDocument) : Result<void>();
}

Result<void> Run(BenchOptions options) {
  if (auto checked = CheckFiles(options); !checked) return checked;
  if (options.measure.sets.empty()) options.measure.sets.assign(kRaySets.begin(), kRaySets.end());
  if (options.no_build) options.measure.builds = 0;
  options.measure.side = std::stoi(options.side);
  BenchResult result;
  result.repetitions = options.measure.repetitions;
  result.build_threads = options.threads;
  if (auto chosen = ChooseIsa(options, &result); !chosen) return chosen;
  if (auto measured = MeasureAll(options, &result); !measured) return measured;
  const std::string tables = Tables(result);
  if (auto printed = WriteResult(tables); !printed) return printed;
  if (options.json) {
    if (auto written = WriteOutput(*options.json, Json(result)); !written) return written;
  }
  if (!options.update) return {};
  if (!options.isa) return UpdateDocument(kDocument, "kernel bench", tables);
  return UpdateDocument(kDocument, "kernel bench " + *options.isa, ShortTable(result));
}

int Main(std::span<const char* const> words) {
  BenchOptions options;
  ArgParser parser(kName, "Measures the ray kernel against Embree.", ArgStyle::kGnu);
  parser.OptionalList(MeshName(&options.meshes),
                      "what is measured: " + ListOf(MeshNames(), "and") +
                          "; the default is all of them, or none when there are files");
  parser.Group("What is measured");
  parser.Option("rays", {RaySetNames(&options.measure.sets)},
                "sets of rays: primary, diffuse, deep, shadow; the default is all of them");
  parser.Option("obj", {File("FILE", &options.files)}, "measure the mesh of this OBJ file as well");
  parser.Option("scale", {Scale(&options.scale)},
                "so many times the triangles, for quick runs; the default is 1");
  parser.Option("side", {Choice("N", &options.side, {"64", "128", "256", "512", "1024", "2048"})},
                "side of the picture in pixels; its square is the number of rays of a set; the "
                "default is 512");
  parser.Flag("no-build", &options.no_build, "do not time builds");
  parser.Group("How it is measured");
  parser.Option("isa", {Choice("ISA", &options.isa, {"scalar", "avx2", "avx512"})},
                "the instruction set of ours; avx2 restricts Embree to it, too");
  parser.Option("repetitions", {Whole("N", &options.measure.repetitions, 1, 1000)},
                "of each measurement, the best counts; the default is 7");
  parser.Option("threads", {Whole("N", &options.threads, 1, 256)},
                "for builds; the default is 2, and 1 counts CPU time; rays have one thread");
  parser.Group("Results");
  parser.Option("json", {File("FILE", &options.json)}, "write everything there");
  parser.Flag("update", &options.update,
              "put the tables into docs/performance.md, with --isa the first one; in the root of "
              "the project");
  parser.Example("--scale 0.05 --repetitions 1", "A quick look whether everything works.");
  return RunBench(parser, words, [&] { return Run(options); });
}

}  // namespace
}  // namespace candela

int main(int argc, char** argv) {
  return candela::Main(candela::WordsOf(argc, argv));
}
