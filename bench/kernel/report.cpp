#include "report.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <vector>

#include "summary.h"

namespace candela {
namespace {

/// A table with columns as wide as their widest cell; the first `left` of them start at the left.
class Table {
 public:
  Table(std::vector<std::string> head, size_t left) : left_(left) { Add(std::move(head)); }

  void Add(std::vector<std::string> cells) { rows_.push_back(std::move(cells)); }

  std::string Text() const {
    std::string text;
    for (size_t i = 0; i < rows_.size(); ++i) {
      for (size_t column = 0; column < rows_[i].size(); ++column) {
        const std::string& cell = rows_[i][column];
        const std::string blanks(Width(column) - cell.size(), ' ');
        text += "| " + (column < left_ ? cell + blanks : blanks + cell) + " ";
      }
      text += "|\n";
      if (i == 0) text += Rule();
    }
    return text;
  }

 private:
  size_t Width(size_t column) const {
    size_t width = 0;
    for (const auto& row : rows_) width = std::max(width, row[column].size());
    return width;
  }
  std::string Rule() const {
    std::string text;
    for (size_t column = 0; column < rows_[0].size(); ++column) {
      text += "|" + std::string(Width(column) + (column < left_ ? 2 : 1), '-');
      if (column >= left_) text += ":";
    }
    return text + "|\n";
  }

  size_t left_;
  std::vector<std::vector<std::string>> rows_;
};

std::string Factor(double x) {
  return fmt::format("{:.2f}", x);
}

std::string SummaryTable(const BenchResult& result) {
  Table table({"figure", "at least", "goal", "mean", "worst mesh"}, 1);
  for (const SummaryRow& row : Summarize(result)) {
    const std::string_view unit = row.less_is_better ? "x" : "";
    const auto number = [&](double x) { return fmt::format("{:.2f}{}", x, unit); };
    // The one figure that has to be small says so.
    table.Add({std::string(row.name), (row.less_is_better ? "at most " : "") + number(row.required),
               number(row.goal), row.mean ? number(*row.mean) : "-",
               row.mean ? fmt::format("{} ({})", number(row.worst), row.worst_scene) : "-"});
  }
  return table.Text();
}

/// Rows of one scene: ratios to `base`.
void AddSpeeds(const SceneResult& scene, const std::string& name, Mode base, Table* table) {
  for (const SetResult& set : scene.sets) {
    std::vector<std::string> cells = {name, std::string(RaySetName(set.set)),
                                      Factor(set.MegaraysPerSecond(base))};
    for (const Mode mode :
         {kEmbreeHigh, kEmbreeRobust, kEmbreePacket, kOurSingle, kOurBatch, kOurPacket, kOurFast}) {
      cells.push_back(Factor(set.Ratio(mode, base)));
    }
    cells.push_back(Factor(set.Ratio(kOurPacket, kEmbreePacket)));
    cells.push_back(Factor(std::max(
        {set.Ratio(kOurSingle, base), set.Ratio(kOurBatch, base), set.Ratio(kOurPacket, base)})));
    table->Add(std::move(cells));
  }
}

std::string SpeedTable(const BenchResult& result) {
  Table table({"mesh", "rays", "medium Mray/s", "high", "robust", "packet16", "single", "batch",
               "packet", "single, fast tree", "packet / packet16", "best of ours"},
              2);
  for (const SceneResult& scene : result.scenes) {
    AddSpeeds(scene, scene.name, kEmbreeMedium, &table);
    // Where Embree's usual tree is bad, a better one than that would flatter us.
    if (scene.name == "uneven") AddSpeeds(scene, "uneven, to high", kEmbreeHigh, &table);
  }
  return table.Text();
}

std::string BuildTable(const BenchResult& result) {
  Table table({"mesh", "triangles", "medium Mtri/s", "high Mtri/s", "fast / medium", "best / high",
               "medium B/tri", "high B/tri", "fast B/tri", "best B/tri"},
              1);
  for (const SceneResult& scene : result.scenes) {
    std::vector<std::string> cells = {scene.name, fmt::format("{}", scene.triangles)};
    if (scene.build_seconds) {
      const auto& seconds = *scene.build_seconds;
      const double millions = static_cast<double>(scene.built_triangles) * 1e-6;
      cells.insert(cells.end(), {Factor(millions / seconds[kBuildMedium]),
                                 Factor(millions / seconds[kBuildHigh]),
                                 Factor(seconds[kBuildMedium] / seconds[kBuildFast]),
                                 Factor(seconds[kBuildHigh] / seconds[kBuildBest])});
    } else {
      cells.insert(cells.end(), 4, "-");
    }
    for (const BuildMode mode : {kBuildMedium, kBuildHigh, kBuildFast, kBuildBest}) {
      cells.push_back(fmt::format("{:.1f}", scene.BytesPerTriangle(mode)));
    }
    table.Add(std::move(cells));
  }
  return table.Text();
}

std::string AgreementTable(const BenchResult& result) {
  Table table({"mesh", "rays", "number", "medium, hit", "medium, t", "best, hit", "best, t",
               "fast, hit", "fast, t", "batch / single", "packet / single"},
              2);
  for (const SceneResult& scene : result.scenes) {
    for (const SetResult& set : scene.sets) {
      const Agreement& agreement = set.agreement;
      std::vector<std::string> cells = {scene.name + (scene.is_closed ? " (closed)" : ""),
                                        std::string(RaySetName(set.set)),
                                        fmt::format("{}", set.rays)};
      for (const Mode mode : {kEmbreeMedium, kOurSingle, kOurFast}) {
        cells.push_back(fmt::format("{}", agreement.from_robust[mode].hit_or_miss));
        cells.push_back(fmt::format("{}", agreement.from_robust[mode].t));
      }
      cells.push_back(fmt::format("{}", agreement.batch_from_single));
      cells.push_back(fmt::format("{}", agreement.packet_from_single));
      table.Add(std::move(cells));
    }
  }
  return table.Text();
}

std::string PeakLine(const BenchResult& result) {
  std::string text;
  for (const SceneResult& scene : result.scenes) {
    if (!scene.peak_bytes) continue;
    text += fmt::format(
        "Peak memory of the process when `{}` was built by us, and not yet by "
        "Embree: {:.0f} MB.\n\n",
        scene.name, *scene.peak_bytes * 1e-6);
  }
  return text;
}

}  // namespace

std::string ShortTable(const BenchResult& result) {
  return fmt::format(
      "Instruction set: {} against {}. Best of {} repetitions, one thread; builds on {}. Geometric "
      "means.\n\n{}",
      result.isa,
      result.embree_isa.empty() ? "the best of Embree's" : "Embree's " + result.embree_isa,
      result.repetitions, result.build_threads, SummaryTable(result));
}

std::string Tables(const BenchResult& result) {
  return fmt::format(
      "{}\n"
      "Rays: Embree's single rays in the tree of medium quality, and everything else as a ratio to "
      "them; what is ours, from `single` on, in the best tree; with AVX-512, single rays "
      "in nodes of 16, lists in nodes of 8.\n\n{}\n"
      "Builds and memory:\n\n{}\n"
      "{}"
      "Answers that differ from Embree's robust ones, in whether there is a hit and in t by more "
      "than 1e-4 of it (in instances, beyond rounding); and answers of our lists that are not the "
      "same bits as those of our single "
      "rays:\n\n{}",
      ShortTable(result), SpeedTable(result), BuildTable(result), PeakLine(result),
      AgreementTable(result));
}

}  // namespace candela
