#include "driver/progress_line.h"

#include <fmt/format.h>

#include <algorithm>

namespace candela {
namespace {

constexpr int kShortestBar = 10, kLongestBar = 40;
constexpr const char* kGreen = "\x1b[32m";
constexpr const char* kPlain = "\x1b[0m";

/// "0.8 s", "59 s", "1 min 05 s", "2 h 07 min".
std::string Duration(double seconds) {
  if (seconds < 9.95) return fmt::format("{:.1f} s", seconds);
  if (seconds > 3.6e8) return "ages";
  const auto whole = static_cast<int64_t>(seconds + 0.5);
  if (whole < 60) return fmt::format("{} s", whole);
  if (whole < 3600) return fmt::format("{} min {:02} s", whole / 60, whole % 60);
  return fmt::format("{} h {:02} min", whole / 3600, whole / 60 % 60);
}

/// "950 rays/s", "3.1 krays/s", "3.1 Mrays/s".
std::string Rate(double rays_per_second) {
  if (rays_per_second < 1e3) return fmt::format("{:.0f} rays/s", rays_per_second);
  if (rays_per_second < 1e6) return fmt::format("{:.1f} krays/s", rays_per_second / 1e3);
  return fmt::format("{:.1f} Mrays/s", rays_per_second / 1e6);
}

}  // namespace

std::string ProgressText(const ProgressState& state) {
  const double fraction = state.fraction;
  // Cut, not rounded: 100% means that it is done.
  std::string text = fmt::format("{}%", static_cast<int>(100 * fraction));
  if (!(state.seconds > 0)) return text;
  text += "  " + Rate(static_cast<double>(state.rays) / state.seconds);
  if (fraction >= 1) return text + "  in " + Duration(state.seconds);
  if (fraction > 0) text += "  " + Duration(state.seconds * (1 / fraction - 1)) + " left";
  return text;
}

std::string ProgressBar(const ProgressState& state, int columns, bool colours) {
  const std::string text = ProgressText(state);
  const auto width = static_cast<size_t>(std::max(columns, 0));
  if (text.size() + kShortestBar + 3 > width) return fmt::format("{:<{}.{}}", text, width, width);
  const int length = std::min(kLongestBar, static_cast<int>(width - text.size()) - 3);
  const int filled = static_cast<int>(length * state.fraction);
  return fmt::format("{}[{:#<{}}{:.<{}}]{} {:<{}}", colours ? kGreen : "", "", filled, "",
                     length - filled, colours ? kPlain : "", text, width - length - 3);
}

}  // namespace candela
