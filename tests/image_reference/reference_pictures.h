#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "image/compare.h"
#include "image/raster.h"

namespace candela::image_reference {

/// How far a picture may be from that of the reference implementation. The last digits of the two
/// differ, so a value at the edge of a byte falls either way, and rays along an edge hit or miss.
struct Bar {
  double differing_percent;  ///< Most pixels that differ at all.
  double beyond_percent;     ///< Most pixels that differ by more than one level,
  int64_t beyond_pixels;     ///< or this many, where that is more.
  double least_psnr;         ///< In decibels.

  int64_t MostDiffering(int64_t pixels) const;
  int64_t MostBeyondOneLevel(int64_t pixels) const;
};

enum class PictureKind { kColour, kNormals, kDepth };

/// One picture of the course's reference implementation.
struct ReferencePicture {
  int scene;  ///< From 1.
  PictureKind kind;
  int side;  ///< In pixels.

  std::string Name() const;  ///< "01_200"; the file is of that name.
  Bar bar() const;
};

/// All of them.
std::span<const ReferencePicture> ReferencePictures();

/// Whether the course's folder is there; it is not part of the project.
bool HaveReference();
/// Says why nothing can be compared.
std::string NoReference();

/// Our picture, the reference's, and how far they are apart.
struct Comparison {
  Image ours, reference;
  ImageDifference difference;
  /// The pixels that count. In a normal map those that are hits: the reference repeats old normals
  /// elsewhere. The others are black in both pictures.
  int64_t compared = 0;

  double DifferingPercent() const;
  bool Meets(const Bar& bar) const;
};

/// Renders and compares; once per picture and process.
const Comparison& CompareWithReference(const ReferencePicture& picture);

}  // namespace candela::image_reference
