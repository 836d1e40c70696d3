// Times the OBJ reader on generated meshes of five million triangles: a wavy grid, once with plain
// corners and once with texture coordinates and normals. Prints one table.
//
// usage: obj_bench [TRIANGLES]

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <iterator>
#include <span>
#include <string>

#include "base/clock.h"
#include "base/diagnostics.h"
#include "base/files.h"
#include "base/memory.h"
#include "base/number.h"
#include "loaders/obj/obj_reader.h"
#include "support/cpu_seconds.h"

namespace candela {
namespace {

namespace fs = std::filesystem;

/// A grid of side * side squares, two triangles each.
std::string GridText(int side, bool with_attributes) {
  std::string text = "# a wavy grid\no grid\n";
  const auto out = std::back_inserter(text);
  for (int y = 0; y <= side; ++y) {
    for (int x = 0; x <= side; ++x) {
      // Six decimals as most exporters write; the heights only have to look like real ones.
      const int wave = (x * 7919 + y * 104729) % 1000003;
      fmt::format_to(out, "v {:.6f} {:.6f} {:.6f}\n", x / 997.0, wave * 1e-6, -y / 997.0);
      if (!with_attributes) continue;
      fmt::format_to(out, "vt {:.6f} {:.6f}\n", x / double(side), y / double(side));
      fmt::format_to(out, "vn {:.6f} 1.000000 {:.6f}\n", wave * 1e-7, wave * -1e-7);
    }
  }
  const auto face = [&](int a, int b, int c) {
    if (with_attributes) {
      fmt::format_to(out, "f {0}/{0}/{0} {1}/{1}/{1} {2}/{2}/{2}\n", a, b, c);
    } else {
      fmt::format_to(out, "f {} {} {}\n", a, b, c);
    }
  };
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      const int corner = y * (side + 1) + x + 1;
      face(corner, corner + 1, corner + side + 2);
      face(corner, corner + side + 2, corner + side + 1);
    }
  }
  return text;
}

/// Prints a row of the table; false when the mesh could not be read.
bool Measure(const char* name, int side, bool with_attributes, const fs::path& folder) {
  const fs::path path = folder / "grid.obj";
  double megabytes = 0;
  {
    const std::string text = GridText(side, with_attributes);
    megabytes = static_cast<double>(text.size()) / 1e6;
    if (!WriteFileAtomically(path, std::as_bytes(std::span(text)))) return false;
  }
  Diagnostics diagnostics;
  const double cpu_before = CpuSeconds();
  const Stopwatch wall;
  const auto mesh = LoadObj(path, {}, &diagnostics);
  const double cpu = CpuSeconds() - cpu_before;
  fs::remove(path);
  for (const std::string& line : diagnostics.Lines()) fmt::print(stderr, "{}\n", line);
  if (!mesh) return false;
  fmt::print("{:12} {:>10} {:>8.1f} {:>8.2f} {:>8.2f} {:>8.0f}\n", name, mesh->triangles.size(),
             megabytes, cpu, wall.Seconds(), megabytes / cpu);
  return true;
}

int Run(int64_t triangles) {
  int side = 1;
  while (int64_t{2} * side * side < triangles) ++side;
  const fs::path folder = fs::temp_directory_path() / "candela-obj-bench";
  fs::create_directories(folder);
  fmt::print("{:12} {:>10} {:>8} {:>8} {:>8} {:>8}\n", "corners", "triangles", "MB", "CPU s",
             "wall s", "MB/s");
  const bool ok = Measure("v", side, false, folder) && Measure("v/vt/vn", side, true, folder);
  fmt::print("peak memory {:.0f} MB, the making of the files included\n", PeakMemory() / 1e6);
  fs::remove_all(folder);
  return ok ? 0 : 1;
}

}  // namespace
}  // namespace candela

int main(int argc, char** argv) {
  const auto triangles = candela::ParseInteger(argc > 1 ? argv[1] : "5000000");
  if (argc > 2 || !triangles || *triangles < 1 || *triangles > 1'000'000'000) {
    fmt::print(stderr, "usage: obj_bench [TRIANGLES]\n");
    return 2;
  }
  return candela::Run(*triangles);
}
