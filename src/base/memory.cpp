#include "base/memory.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <limits>
#include <optional>
#include <string>

#include "base/number.h"
#include "base/platform.h"

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

/// The number after `key` in a file of lines "key number".
std::optional<uint64_t> ReadEntry(const std::filesystem::path& path, const std::string& key) {
  std::ifstream stream(path);
  std::string name, rest;
  uint64_t value = 0;
  while (stream >> name >> value && std::getline(stream, rest)) {
    if (name == key) return value;
  }
  return std::nullopt;
}

/// What the two versions of control groups call the same things.
struct GroupFiles {
  const char* limit;
  const char* used;
  const char* cached_entry;  ///< in memory.stat
};
constexpr GroupFiles kVersion1 = {"memory.limit_in_bytes", "memory.usage_in_bytes",
                                  "total_inactive_file"};
constexpr GroupFiles kVersion2 = {"memory.max", "memory.current", "inactive_file"};

uint64_t LeftIn(const std::filesystem::path& group, const GroupFiles& files) {
  const auto limit = ReadBytes(group / files.limit);
  if (!limit) return kUnlimited;
  const uint64_t used = ReadBytes(group / files.used).value_or(0);
  const uint64_t cached = ReadEntry(group / "memory.stat", files.cached_entry).value_or(0);
  const uint64_t needed = used - std::min(used, cached);
  return *limit - std::min(*limit, needed);
}

}  // namespace

uint64_t SystemMemoryAvailable() {
  const auto kibibytes = ReadEntry("/proc/meminfo", "MemAvailable:");
  return kibibytes ? *kibibytes * 1024 : kUnlimited;
}

uint64_t ControlGroupMemoryLeft(const std::filesystem::path& list,
                                const std::filesystem::path& mount) {
  uint64_t left = kUnlimited;
  std::ifstream stream(list);
  for (std::string line; std::getline(stream, line);) {
    // "0::/path" for version 2, "N:memory:/path" for version 1.
    const size_t first = line.find(':');
    const size_t second = first == std::string::npos ? first : line.find(':', first + 1);
    if (second == std::string::npos) continue;
    const std::string controllers = line.substr(first + 1, second - first - 1);
    const bool is_version_2 = controllers.empty();
    if (!is_version_2 && controllers != "memory") continue;

    // Every group on the way up to the root may hold a limit of its own.
    const std::filesystem::path top = is_version_2 ? mount : mount / "memory";
    auto below = std::filesystem::path(line.substr(second + 1)).relative_path();
    while (true) {
      left = std::min(left, LeftIn(top / below, is_version_2 ? kVersion2 : kVersion1));
      if (below.empty()) break;
      below = below.parent_path();
    }
  }
  return left;
}

uint64_t AvailableMemory() {
  return std::min(SystemMemoryAvailable(),
                  ControlGroupMemoryLeft("/proc/self/cgroup", "/sys/fs/cgroup"));
}

uint64_t PeakMemory() {
  return platform::PeakMemory();
}

}  // namespace candela
