#include "tests/layering/layering_rules.h"

#include <fmt/format.h>

#include <algorithm>
#include <regex>
#include <set>

namespace candela::layering {
namespace {

const std::vector<Row> kTable = {
    {"apps", {"render", "loaders", "image", "fluid"}},
    {"render", {"integrators", "film", "scene"}},
    {"integrators", {"scene", "sampling"}},
    {"scene",
     {"kernel", "shapes", "textures", "materials", "media", "lights", "cameras", "scene_spec"}},
    {"lights", {"shapes", "textures"}},
    {"materials", {"textures"}},
    {"media", {"textures"}},
    {"shapes", {"kernel", "textures", "scene_spec"}},
    {"textures", {"scene_spec", "sampling", "geometry", "image"}},
    {"cameras", {"scene_spec", "sampling", "geometry"}},
    {"loaders", {"scene_spec"}},
    {"fluid", {"scene_spec", "shapes"}},
    {"film", {"image", "sampling"}},
    {"kernel", {"geometry"}},
    {"scene_spec", {"math", "base"}},
    {"sampling", {"math"}},
    {"geometry", {"math"}},
    {"image", {"math"}},
    {"math", {"base"}},
    {"base", {}},
};

/// Code that has its place: the pattern may appear only in paths that start with one of `places`.
struct Rule {
  const char* name;
  std::regex pattern;
  std::vector<std::string_view> places;
};
const std::vector<Rule> kRules = {
    {"platform headers belong in base/posix/",
     std::regex(R"(#\s*include\s*<(sys/|unistd|fcntl|signal\.h|dlfcn|pthread|sched|poll|termios|)"
                R"(dirent|spawn|mach/|[Ww]indows))"),
     {"src/base/posix/"}},
    {"the threading library belongs in base/parallel.cpp",
     std::regex(R"(#\s*include\s*<(tbb|oneapi)/)"),
     {"src/base/parallel.cpp"}},
    {"intrinsics belong in kernel/simd/",
     std::regex(R"(#\s*include\s*<(\w*mmintrin|\w*86intrin|arm_neon|arm_sve)\.h>)"),
     {"src/kernel/simd/"}},
    {"only programs print",
     std::regex(R"(std::(cout|cerr|clog)\b|\b(v?f?printf|f?put[sc]|putchar|fwrite|perror)\s*\()"
                R"(|fmt::v?print\s*\()"),
     {"apps/", "src/base/check.cpp"}},
    {"only programs exit",
     std::regex(R"(\b(exit|_exit|_Exit|quick_exit|abort|terminate)\s*\()"),
     {"apps/", "src/base/check.cpp", "src/base/signals.cpp"}},
    {"libm differs between machines: use math/elementary.h",
     std::regex(R"(\b(a?(sin|cos|tan)h?|atan2|exp2?|expm1|log(2|10|1p|b)?|pow|cbrt|hypot|erfc?|)"
                R"([lt]gamma)[fl]?\s*\()"),
     {"src/math/"}},
    {"distributions of the standard library differ between compilers",
     std::regex(R"(\bstd::\w+_distribution\b)"),
     {}},
};

void AddReachable(std::string_view folder, std::set<std::string_view>* reached) {
  if (!reached->insert(folder).second) return;
  for (const Row& row : kTable) {
    if (row.folder != folder) continue;
    for (const std::string_view next : row.may_include) AddReachable(next, reached);
  }
}

bool MayInclude(std::string_view from, std::string_view to) {
  std::set<std::string_view> reached;
  AddReachable(from, &reached);
  return reached.contains(to);
}

/// The folder of `#include "folder/..."`; empty when the line has no quoted include.
std::string IncludedFolder(const std::string& line) {
  static const std::regex kInclude(R"re(^\s*#\s*include\s*"([^"]*)")re");
  std::smatch match;
  if (!std::regex_search(line, match, kInclude)) return {};
  const std::string path = match[1];
  return path.find('/') == std::string::npos ? path : path.substr(0, path.find('/'));
}

}  // namespace

const std::vector<Row>& Table() {
  return kTable;
}

std::string FolderOf(std::string_view path) {
  const size_t first = path.find('/');
  if (path.substr(0, first) == "apps") return "apps";
  const size_t second = path.find('/', first + 1);
  return std::string(path.substr(first + 1, second - first - 1));
}

bool IsKnownFolder(std::string_view folder) {
  return std::any_of(kTable.begin(), kTable.end(),
                     [&](const Row& row) { return row.folder == folder; });
}

std::vector<std::string> Breaches(std::string_view path, std::string_view source) {
  std::vector<std::string> breaches;
  const std::string folder = FolderOf(path);
  const std::string code = CodeOf(source);
  int number = 0;
  for (size_t start = 0; start < code.size(); ++number) {
    const size_t end = std::min(code.find('\n', start), code.size());
    const std::string line = code.substr(start, end - start);
    start = end + 1;
    const auto add = [&](std::string_view text) {
      breaches.push_back(fmt::format("{}:{}: {}", path, number + 1, text));
    };

    const std::string included = IncludedFolder(line);
    const bool is_own_program = folder == "apps" && !IsKnownFolder(included);
    if (!included.empty() && !is_own_program && !MayInclude(folder, included)) {
      add(fmt::format("{}/ may not include {}/", folder, included));
    }
    for (const Rule& rule : kRules) {
      const bool is_at_home =
          std::any_of(rule.places.begin(), rule.places.end(),
                      [&](std::string_view place) { return path.starts_with(place); });
      if (!is_at_home && std::regex_search(line, rule.pattern)) add(rule.name);
    }
  }
  return breaches;
}

}  // namespace candela::layering
