#include "scene_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>
#include <system_error>

#include "driver/picture_files.h"
#include "image/exr.h"
#include "math/elementary.h"
#include "math/vec.h"

namespace candela {
namespace {

namespace fs = std::filesystem;

constexpr const char* kCube =
    "v -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\nv -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\n"
    "vn 0 0 -1\nvn 0 0 1\nvn 0 -1 0\nvn 0 1 0\nvn -1 0 0\nvn 1 0 0\n"
    "f 1//1 4//1 3//1 2//1\nf 5//2 6//2 7//2 8//2\nf 1//3 2//3 6//3 5//3\n"
    "f 4//4 8//4 7//4 3//4\nf 1//5 5//5 8//5 4//5\nf 2//6 3//6 7//6 6//6\n";

/// A figure of a million triangles: a ball with waves of several sizes, on the ground.
constexpr int kRows = 501, kColumns = 1001;

Vec3 FigurePoint(int row, int column) {
  const double up = kPi * row / (kRows - 1), around = 2 * kPi * column / (kColumns - 1);
  const double waves = 0.08 * Sin(5 * up) * Sin(4 * around) +
                       0.02 * Sin(31 * up) * Sin(24 * around) +
                       0.004 * Sin(150 * up) * Sin(2 * kPi * 25 * column / (kColumns - 1));
  const double radius = 1.2 * (1 + waves * Sin(up) * Sin(up));
  return {static_cast<float>(radius * Sin(up) * Cos(around)),
          static_cast<float>(1.25 - radius * Cos(up)),
          static_cast<float>(radius * Sin(up) * Sin(around))};
}

/// From the points beside it; at the poles the waves are flat.
Vec3 FigureNormal(int row, int column) {
  if (row == 0) return {0, -1, 0};
  if (row == kRows - 1) return {0, 1, 0};
  const int last = kColumns - 1;
  const Vec3 along = FigurePoint(row + 1, column) - FigurePoint(row - 1, column);
  const Vec3 around =
      FigurePoint(row, (column + 1) % last) - FigurePoint(row, (column + last - 1) % last);
  return Normalize(Cross(along, around));
}

std::string Figure() {
  std::string text;
  const auto to = std::back_inserter(text);
  for (int row = 0; row < kRows; ++row) {
    for (int column = 0; column < kColumns; ++column) {
      const Vec3 p = FigurePoint(row, column), n = FigureNormal(row, column);
      fmt::format_to(to, "v {:.6f} {:.6f} {:.6f}\nvn {:.5f} {:.5f} {:.5f}\n", p.x, p.y, p.z, n.x,
                     n.y, n.z);
    }
  }
  for (int row = 0; row + 1 < kRows; ++row) {
    for (int column = 0; column + 1 < kColumns; ++column) {
      const int a = row * kColumns + column + 1, b = a + 1, c = b + kColumns, d = a + kColumns;
      // At the poles one of the two has no area.
      if (row + 2 < kRows) fmt::format_to(to, "f {0}//{0} {1}//{1} {2}//{2}\n", a, d, c);
      if (row > 0) fmt::format_to(to, "f {0}//{0} {1}//{1} {2}//{2}\n", a, c, b);
    }
  }
  return text;
}

/// Blue, brighter at the horizon, with a sun of 6 degrees.
Image Sky() {
  constexpr int kWidth = 1024, kHeight = 512;
  const Vec3 to_sun = Normalize(Vec3{0.6f, 0.7f, 0.5f});
  const float edge = static_cast<float>(CosDegrees(3));
  Image sky(kWidth, kHeight, 3);
  for (int y = 0; y < kHeight; ++y) {
    const double down = kPi * (y + 0.5) / kHeight;
    for (int x = 0; x < kWidth; ++x) {
      // The middle is -z, the quarter to the right of it +x.
      const double right = 2 * kPi * ((x + 0.5) / kWidth - 0.5);
      const Vec3 d{static_cast<float>(Sin(down) * Sin(right)), static_cast<float>(Cos(down)),
                   static_cast<float>(-Sin(down) * Cos(right))};
      const float height = std::max(0.0f, d.y);
      Rgb color = Rgb{0.3f, 0.5f, 0.9f} * height + Rgb{0.9f, 0.85f, 0.8f} * (1 - height) * 0.6f;
      if (Dot(d, to_sun) > edge) color = {250, 230, 190};
      for (int c = 0; c < 3; ++c) sky.At(x, y, c) = color[c];
    }
  }
  return sky;
}

}  // namespace

Result<void> WriteSceneFiles(const fs::path& scenes, const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  for (const char* name : {"cornell.txt", "glass.txt", "statue.txt"}) {
    if (error) break;
    fs::copy_file(scenes / name, folder / name, fs::copy_options::overwrite_existing, error);
  }
  if (error) return Error{ErrorCode::kOutput, folder.string() + ": " + error.message()};
  if (auto done = WriteOutput(folder / "cube.obj", kCube); !done) return done;
  if (auto done = WriteOutput(folder / "statue.obj", Figure()); !done) return done;
  const Result<std::string> sky = EncodeExr(Sky());
  if (!sky) return sky.error();
  return WriteOutput(folder / "sky.exr", *sky);
}

}  // namespace candela
