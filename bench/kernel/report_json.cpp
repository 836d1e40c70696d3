#include <nlohmann/json.hpp>

#include "report.h"
#include "summary.h"

namespace candela {
namespace {

using nlohmann::ordered_json;

/// One member for each of the names.
template <class Names, class Values>
ordered_json ByName(const Names& names, const Values& values) {
  ordered_json object = ordered_json::object();
  for (size_t i = 0; i < names.size(); ++i) object[std::string(names[i])] = values[i];
  return object;
}

ordered_json ToJson(const SetResult& set) {
  ordered_json from_robust = ordered_json::object();
  for (size_t mode = 0; mode < kModes; ++mode) {
    const Differences& differences = set.agreement.from_robust[mode];
    from_robust[std::string(kModeNames[mode])] = {{"hit_or_miss", differences.hit_or_miss},
                                                  {"t", differences.t}};
  }
  return {{"set", RaySetName(set.set)},
          {"rays", set.rays},
          {"seconds", ByName(kModeNames, set.seconds)},
          {"differences_from_robust", from_robust},
          {"differences_of_batch_from_single", set.agreement.batch_from_single},
          {"differences_of_packet_from_single", set.agreement.packet_from_single}};
}

ordered_json ToJson(const SceneResult& scene) {
  ordered_json object = {{"mesh", scene.name},
                         {"in_summary", scene.in_summary},
                         {"is_closed", scene.is_closed},
                         {"triangles", scene.triangles},
                         {"built_triangles", scene.built_triangles},
                         {"tree_bytes", ByName(kBuildNames, scene.bytes)}};
  if (scene.peak_bytes) object["peak_bytes"] = *scene.peak_bytes;
  if (scene.build_seconds) object["build_seconds"] = ByName(kBuildNames, *scene.build_seconds);
  object["sets"] = ordered_json::array();
  for (const SetResult& set : scene.sets) object["sets"].push_back(ToJson(set));
  return object;
}

ordered_json ToJson(const SummaryRow& row) {
  ordered_json object = {{"figure", row.name},
                         {row.less_is_better ? "at_most" : "at_least", row.required},
                         {"goal", row.goal},
                         {"is_met", row.IsMet()}};
  if (row.mean) {
    object["mean"] = *row.mean;
    object["worst"] = row.worst;
    object["worst_mesh"] = row.worst_scene;
  }
  return object;
}

}  // namespace

std::string Json(const BenchResult& result) {
  ordered_json object = {{"isa", result.isa},
                         {"embree_max_isa", result.embree_isa},
                         {"repetitions", result.repetitions},
                         {"build_threads", result.build_threads}};
  object["scenes"] = ordered_json::array();
  for (const SceneResult& scene : result.scenes) object["scenes"].push_back(ToJson(scene));
  object["summary"] = ordered_json::array();
  for (const SummaryRow& row : Summarize(result)) object["summary"].push_back(ToJson(row));
  return object.dump(2) + "\n";
}

}  // namespace candela
