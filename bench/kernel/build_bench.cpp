// Measures what builds of trees do in bad cases: how long degenerate geometry takes compared with
// ordinary geometry of the same size, and how soon a build answers that is told to stop. Prints
// tables.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "base/cancel_token.h"
#include "base/check.h"
#include "base/clock.h"
#include "base/parallel.h"
#include "driver/arg_parser.h"
#include "driver/console.h"
#include "support/document_table.h"
#include "support/run_bench.h"
#include "tests/kernel/degenerate_scenes.h"

namespace candela {
namespace {

constexpr const char* kName = "build_bench";

constexpr BuildQuality kQualities[] = {BuildQuality::kFast, BuildQuality::kBest};

struct BenchOptions {
  int repetitions = 5;
  int threads = 2;
  bool update = false;
};

uint64_t PrimitivesOf(const GroupInput& input) {
  uint64_t count = 0;
  for (const GroupItem& item : input) {
    if (const auto* mesh = std::get_if<TriangleInput>(&item.content)) {
      count += mesh->triangles.size();
    } else if (const auto* set = std::get_if<PrimitiveInput>(&item.content)) {
      count += set->set->PrimitiveCount();
    } else {
      ++count;
    }
  }
  return count;
}

double BuildSeconds(const GroupInput& input, BuildQuality quality) {
  BuildOptions options;
  options.quality = quality;
  GroupInput copy = input;
  const Stopwatch stopwatch;
  const auto group = Group::Build(std::move(copy), options);
  CHECK(group.ok());
  return stopwatch.Seconds();
}

/// Smaller scenes are over before a clock can tell.
constexpr uint64_t kLeastPrimitives = 100;

/// A scene beside a soup of ordinary triangles, as many as it has primitives. Both take turns, and
/// the shortest build of each counts.
struct Comparison {
  std::string name;
  uint64_t primitives;
  double seconds[2], ratio[2];  ///< For each quality.
};

Comparison Compare(std::string name, const GroupInput& input, int repetitions) {
  Comparison comparison{std::move(name), PrimitivesOf(input), {}, {}};
  test::UniformNumbers random(1);
  const test::GroupDescription soup =
      test::OfMesh(test::Soup(static_cast<uint32_t>(comparison.primitives), 0.05f, 0.5f, &random));
  const Result<GroupInput> usual = test::InputOf(soup, {});
  CHECK(usual.ok());
  const int turns = comparison.primitives < 10'000 ? 20 * repetitions : repetitions;
  for (const BuildQuality quality : kQualities) {
    double best = std::numeric_limits<double>::infinity(), best_usual = best;
    for (int turn = 0; turn < turns; ++turn) {
      best = std::min(best, BuildSeconds(input, quality));
      best_usual = std::min(best_usual, BuildSeconds(*usual, quality));
    }
    const int index = quality == BuildQuality::kBest;
    comparison.seconds[index] = best;
    comparison.ratio[index] = best / best_usual;
  }
  return comparison;
}

std::string DegenerateTable(const BenchOptions& bench) {
  std::vector<Comparison> all;
  for (const test::DegenerateScene& scene : test::DegenerateScenes()) {
    const test::GroupDescription description = scene.make();
    const Result<GroupInput> input = test::InputOf(description, {});
    CHECK(input.ok());
    if (PrimitivesOf(*input) < kLeastPrimitives) continue;
    all.push_back(Compare(scene.name, *input, bench.repetitions));
  }
  std::ranges::sort(all, std::greater(),
                    [](const Comparison& each) { return std::max(each.ratio[0], each.ratio[1]); });
  constexpr size_t kShown = 12;
  std::string table = fmt::format(
      "The slowest {} of {} degenerate scenes with at least {} primitives, in ratio to a soup of "
      "ordinary triangles as large, on {} threads:\n\n"
      "| scene | primitives | fast, ms | ratio | best, ms | ratio |\n"
      "|---|---:|---:|---:|---:|---:|\n",
      std::min(kShown, all.size()), all.size(), kLeastPrimitives, bench.threads);
  for (const Comparison& each : std::span(all).first(std::min(kShown, all.size()))) {
    table +=
        fmt::format("| {} | {} | {:.2f} | {:.2f} | {:.2f} | {:.2f} |\n", each.name, each.primitives,
                    1000 * each.seconds[0], each.ratio[0], 1000 * each.seconds[1], each.ratio[1]);
  }
  return table;
}

/// From the request to the answer, in seconds; none when it was built before.
std::optional<double> SecondsToStop(const GroupInput& input, BuildQuality quality, double after) {
  CancelToken cancel;
  BuildOptions options;
  options.quality = quality;
  options.cancel = &cancel;
  const Stopwatch stopwatch;
  double asked = 0;
  std::thread asker([&] {
    std::this_thread::sleep_for(std::chrono::duration<double>(after));
    asked = stopwatch.Seconds();
    cancel.Cancel();
  });
  GroupInput copy = input;
  const auto group = Group::Build(std::move(copy), options);
  const double end = stopwatch.Seconds();
  asker.join();
  if (group.ok()) return std::nullopt;
  CHECK(group.error().code == ErrorCode::kStopped);
  return end - asked;
}

std::string CancelTable() {
  const test::GroupDescription grid = test::OfMesh(test::CurvedGrid(2237, 0.3f));
  const Result<GroupInput> input = test::InputOf(grid, {});
  CHECK(input.ok());
  std::string table = fmt::format(
      "| told to stop, of {} triangles, after | fast, ms | best, ms |\n|---|---:|---:|\n",
      PrimitivesOf(*input));
  for (const double after : {0.02, 0.1, 0.3, 0.6, 1.0, 1.5}) {
    table += fmt::format("| {} s |", after);
    for (const BuildQuality quality : kQualities) {
      const auto seconds = SecondsToStop(*input, quality, after);
      table += seconds ? fmt::format(" {:.0f} |", 1000 * *seconds) : " built |";
    }
    table += '\n';
  }
  return table;
}

int Main(std::span<const char* const> words) {
  BenchOptions options;
  ArgParser parser(kName, "Measures builds of trees in bad cases.", ArgStyle::kGnu);
  parser.Group("Options");
  parser.Option("repetitions", {Whole("N", &options.repetitions, 1, 1000)},
                "of each build, the best counts; the default is 5");
  parser.Option("threads", {Whole("N", &options.threads, 1, 256)}, "the default is 2");
  parser.Flag("update", &options.update,
              "put the tables into docs/performance.md; in the root of the project");
  return RunBench(parser, words, [&] {
    const ThreadLimit limit(options.threads);
    return Publish("build bench", DegenerateTable(options) + '\n' + CancelTable(), options.update);
  });
}

}  // namespace
}  // namespace candela

int main(int argc, char** argv) {
  return candela::Main(candela::WordsOf(argc, argv));
}
