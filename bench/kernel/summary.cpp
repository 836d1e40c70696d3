#include "summary.h"

#include <algorithm>
#include <cmath>

namespace candela {
namespace {

using Figure = std::optional<double> (*)(const SceneResult&);

struct Target {
  std::string_view name;
  double required, goal;
  Figure figure;
  bool less_is_better = false;
};

template <RaySet kSet, Mode kOurs, Mode kTheirs>
std::optional<double> Speed(const SceneResult& scene) {
  for (const SetResult& result : scene.sets) {
    if (result.set == kSet) return result.Ratio(kOurs, kTheirs);
  }
  return std::nullopt;
}

std::optional<double> BestShadowMode(const SceneResult& scene) {
  const auto single = Speed<RaySet::kShadow, kOurSingle, kEmbreeMedium>(scene);
  const auto batch = Speed<RaySet::kShadow, kOurBatch, kEmbreeMedium>(scene);
  const auto packet = Speed<RaySet::kShadow, kOurPacket, kEmbreeMedium>(scene);
  return single ? std::optional(std::max({*single, *batch, *packet})) : std::nullopt;
}

std::optional<double> Memory(const SceneResult& scene) {
  return scene.bytes[kBuildBest] / scene.bytes[kBuildMedium];
}

template <BuildMode kOurs, BuildMode kTheirs>
std::optional<double> BuildSpeed(const SceneResult& scene) {
  if (!scene.build_seconds) return std::nullopt;
  return (*scene.build_seconds)[kTheirs] / (*scene.build_seconds)[kOurs];
}

constexpr Target kTargets[] = {
    {"primary, single", 1.10, 1.25, &Speed<RaySet::kPrimary, kOurSingle, kEmbreeMedium>},
    {"primary, packet / Embree packet16", 1.0, 1.15,
     &Speed<RaySet::kPrimary, kOurPacket, kEmbreePacket>},
    {"diffuse, single", 1.15, 1.3, &Speed<RaySet::kDiffuse, kOurSingle, kEmbreeMedium>},
    {"diffuse, batch", 1.4, 1.8, &Speed<RaySet::kDiffuse, kOurBatch, kEmbreeMedium>},
    {"deep, single", 1.2, 1.35, &Speed<RaySet::kDeep, kOurSingle, kEmbreeMedium>},
    {"deep, batch", 2.0, 3.0, &Speed<RaySet::kDeep, kOurBatch, kEmbreeMedium>},
    {"shadow, best mode", 1.2, 1.4, &BestShadowMode},
    {"bytes per triangle", 0.75, 0.65, &Memory, true},
    {"build fast / medium", 0.9, 1.2, &BuildSpeed<kBuildFast, kBuildMedium>},
    {"build best / high", 1.0, 1.5, &BuildSpeed<kBuildBest, kBuildHigh>},
};

SummaryRow Summarize(const Target& target, const std::vector<SceneResult>& scenes) {
  SummaryRow row{target.name, target.required, target.goal, target.less_is_better, {}, 0, {}};
  double sum_of_logs = 0;
  int count = 0;
  for (const SceneResult& scene : scenes) {
    const std::optional<double> value = scene.in_summary ? target.figure(scene) : std::nullopt;
    if (!value) continue;
    sum_of_logs += std::log(*value);
    ++count;
    const bool is_worse = row.less_is_better ? *value > row.worst : *value < row.worst;
    if (count > 1 && !is_worse) continue;
    row.worst = *value;
    row.worst_scene = scene.name;
  }
  if (count > 0) row.mean = std::exp(sum_of_logs / count);
  return row;
}

}  // namespace

std::vector<SummaryRow> Summarize(const BenchResult& result) {
  std::vector<SummaryRow> rows;
  for (const Target& target : kTargets) rows.push_back(Summarize(target, result.scenes));
  return rows;
}

}  // namespace candela
