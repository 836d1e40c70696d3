#include "base/memory.h"

#include <sys/resource.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <limits>
#include <optional>
#include <string>

#include "base/number.h"

namespace candela {
namespace {

constexpr uint64_t kUnlimited = std::numeric_limits<uint64_t>::max();

/// The first word of a file as a number of bytes; "max" and unreadable files say nothing.
std::optional<uint64_t> ReadBytes(const std::filesystem::path& path) {
  std::ifstream stream(path);
  std::string word;
  stream >> word;
  const auto value = ParseInteger(word);
  if (!value || *value < 0) return std::nullopt;
  return static_cast<uint64_t>(*value);
}

uint64_t SystemAvailable() {
  std::ifstream stream("/proc/meminfo");
  std::string key;
  uint64_t kibibytes = 0;
  std::string unit;
  while (stream >> key >> kibibytes && std::getline(stream, unit)) {
    if (key == "MemAvailable:") return kibibytes * 1024;
  }
  return kUnlimited;
}

uint64_t LeftIn(const std::filesystem::path& group, const char* limit_name, const char* used_name) {
  const auto limit = ReadBytes(group / limit_name);
  if (!limit) return kUnlimited;
  const uint64_t used = ReadBytes(group / used_name).value_or(0);
  return *limit > used ? *limit - used : 0;
}

/// Every group on the way up to the root may hold a limit of its own.
uint64_t ControlGroupsLeave() {
  uint64_t left = kUnlimited;
  std::ifstream stream("/proc/self/cgroup");
  for (std::string line; std::getline(stream, line);) {
    // "0::/path" for version 2, "N:memory:/path" for version 1.
    const size_t first = line.find(':');
    const size_t second = first == std::string::npos ? first : line.find(':', first + 1);
    if (second == std::string::npos) continue;
    const std::string controllers = line.substr(first + 1, second - first - 1);
    const bool is_version_2 = controllers.empty();
    if (!is_version_2 && controllers.find("memory") == std::string::npos) continue;

    const std::filesystem::path top = is_version_2 ? "/sys/fs/cgroup" : "/sys/fs/cgroup/memory";
    std::filesystem::path below = std::filesystem::path(line.substr(second + 1)).relative_path();
    while (true) {
      const auto group = top / below;
      left = std::min(left, is_version_2
                                ? LeftIn(group, "memory.max", "memory.current")
                                : LeftIn(group, "memory.limit_in_bytes", "memory.usage_in_bytes"));
      if (below.empty()) break;
      below = below.parent_path();
    }
  }
  return left;
}

}  // namespace

uint64_t AvailableMemory() {
  return std::min(SystemAvailable(), ControlGroupsLeave());
}

uint64_t PeakMemory() {
  rusage usage{};
  if (getrusage(RUSAGE_SELF, &usage) != 0) return 0;
#ifdef __APPLE__
  return static_cast<uint64_t>(usage.ru_maxrss);  // Bytes there, KiB elsewhere.
#else
  return static_cast<uint64_t>(usage.ru_maxrss) * 1024;
#endif
}

}  // namespace candela
