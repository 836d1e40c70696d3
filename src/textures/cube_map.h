#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <variant>
#include <vector>

#include "base/diagnostics.h"
#include "image/raster.h"
#include "math/spectrum.h"

namespace candela {

/// Six pictures of the surroundings, one for each side of a cube, looked up by direction. Blends
/// the four nearest texels of a face, not across faces. The faces lie as in the course, whose
/// `back` is mirrored left to right and whose `down` is upside down. Immutable; called
/// concurrently.
class CubeMap {
 public:
  /// Reads left, right, up, down, front and back `.png` from `folder`: of any size each, grey or
  /// coloured, 8 or 16 bits; alpha is not used. A file that cannot be read is reported at `asked`,
  /// the place that asks for it, one with wrong content under its own name.
  static std::optional<CubeMap> Load(const std::filesystem::path& folder,
                                     const SourceLocation& asked, Diagnostics* diagnostics);

  /// The files that `Load` reads.
  static std::vector<std::filesystem::path> FaceFiles(const std::filesystem::path& folder);

  /// The colour in a direction of any length but 0, from 0 to 1.
  Rgb Lookup(Vec3 direction) const;

  uint64_t MemoryBytes() const;

 private:
  enum FaceIndex { kLeft, kRight, kUp, kDown, kFront, kBack, kFaces };
  /// Three channels; kept as in the file, since floats would take four times the memory.
  using Face = std::variant<ByteImage, WordImage>;

  std::array<Face, kFaces> faces_;
};

}  // namespace candela
