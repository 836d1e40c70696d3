#include "driver/render_report.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

namespace candela {
namespace {

std::string Row(std::string_view name, double value, std::string_view unit) {
  return fmt::format("  {:<12}{:>14.3f} {}\n", name, value, unit);
}

std::string Row(std::string_view name, uint64_t count) {
  return fmt::format("  {:<12}{:>14}\n", name, count);
}

std::string Samples(double mean) {
  return mean == std::floor(mean) ? fmt::format("{:.0f}", mean) : fmt::format("{:.1f}", mean);
}

/// A whole number as such.
nlohmann::ordered_json Number(double value) {
  const auto whole = static_cast<uint64_t>(value);
  if (static_cast<double>(whole) == value) return whole;
  return value;
}

double Mebibytes(uint64_t bytes) {
  return static_cast<double>(bytes) / (1 << 20);
}

}  // namespace

std::string StatisticsToText(const RenderStatistics& statistics) {
  const RenderStatistics::Phases& seconds = statistics.seconds;
  const RayCounts& rays = statistics.rays;
  std::string text = fmt::format("{}: {} x {} pixels, {} samples each, {}, {} threads, {}, {}\n",
                                 statistics.scene, statistics.width, statistics.height,
                                 Samples(statistics.samples_per_pixel), statistics.integrator,
                                 statistics.threads, statistics.accelerator, statistics.isa);
  text += "time\n" + Row("load", seconds.load, "s") + Row("build", seconds.build, "s") +
          Row("render", seconds.render, "s") + Row("encode", seconds.encode, "s") +
          Row("write", seconds.write, "s") + Row("total", seconds.Total(), "s");
  text += "rays\n" + Row("camera", rays.camera) + Row("reflection", rays.reflection) +
          Row("shadow", rays.shadow) + Row("total", rays.Total()) +
          Row("rate", statistics.RaysPerSecond() / 1e6, "Mrays/s");
  text += "memory\n" + Row("scene", Mebibytes(statistics.scene_bytes), "MiB");
  if (statistics.peak_bytes > 0) text += Row("peak", Mebibytes(statistics.peak_bytes), "MiB");
  if (statistics.dropped_samples > 0) {
    text += "samples\n" + Row("dropped", statistics.dropped_samples);
  }
  return text;
}

std::string StatisticsToJson(const RenderStatistics& statistics) {
  const RenderStatistics::Phases& seconds = statistics.seconds;
  const RayCounts& rays = statistics.rays;
  const nlohmann::ordered_json json = {{"scene", statistics.scene},
                                       {"integrator", statistics.integrator},
                                       {"width", statistics.width},
                                       {"height", statistics.height},
                                       {"samples_per_pixel", Number(statistics.samples_per_pixel)},
                                       {"threads", statistics.threads},
                                       {"accelerator", statistics.accelerator},
                                       {"isa", statistics.isa},
                                       {"seconds",
                                        {{"load", seconds.load},
                                         {"build", seconds.build},
                                         {"render", seconds.render},
                                         {"encode", seconds.encode},
                                         {"write", seconds.write},
                                         {"total", seconds.Total()}}},
                                       {"rays",
                                        {{"camera", rays.camera},
                                         {"reflection", rays.reflection},
                                         {"shadow", rays.shadow},
                                         {"total", rays.Total()}}},
                                       {"rays_per_second", statistics.RaysPerSecond()},
                                       {"dropped_samples", statistics.dropped_samples},
                                       {"scene_bytes", statistics.scene_bytes},
                                       {"peak_bytes", statistics.peak_bytes}};
  // A scene's name may hold any bytes; JSON holds text.
  return json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

}  // namespace candela
