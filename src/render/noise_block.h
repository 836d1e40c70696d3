#pragma once

#include <array>
#include <cstdint>

#include "film/film.h"
#include "render/sample_tracer.h"

namespace candela {

/// A block of pixels that gets samples until its noise is below a target.
///
/// Whoever stops when the samples so far look alike stops too often while something bright has not
/// been met yet, and gets a picture that is too dark. So there are two series of samples, and how
/// many of one come into the picture depends on those of the other alone: each is a mean of as many
/// samples as something independent has said, and the pixel is the mean of the two. The series that
/// is wanted longer says when; what the other one has to go on for until then is only looked at,
/// not added to the picture.
class NoiseBlock {
 public:
  /// Blocks lie in the whole picture at multiples of this, whatever part of it is rendered.
  static constexpr int kSide = 16;
  /// A series ends when of a block's pixels at most this part has more noise than the target, by
  /// the other's measure. Less than the 5 % that are promised, since two measures never agree.
  static constexpr double kNoisyPart = 0.03;

  /// Begins with no samples. The film and the options, which have a noise target, have to outlive
  /// it.
  NoiseBlock(const PixelWindow& window, const RenderOptions& options, const Film& film);

  /// Adds samples to both series. False when that was stopped on request; then it is of no use.
  bool Advance(SampleTracer* tracer);
  bool IsDone() const { return ended_[0] && ended_[1]; }
  /// Whether more samples would be needed than there may be.
  bool HasMissedTarget() const { return missed_; }

  /// Samples of each pixel that are in the picture.
  uint32_t SamplesInPicture() const { return samples_[0] + samples_[1]; }
  const PixelWindow& Window() const { return running_[0].Window(); }
  /// What comes into the picture so far.
  void Show(Film* film) const { film->EndSeries(Shown(0), Shown(1)); }

 private:
  const FilmTile& Shown(size_t series) const {
    return kept_[series].Window() == Window() ? kept_[series] : running_[series];
  }
  bool IsQuiet(const FilmTile& tile) const;
  void End();

  const float target_;
  const uint32_t most_;  ///< Samples of each pixel in a series.
  std::array<FilmTile, 2> running_;
  std::array<FilmTile, 2> kept_;  ///< Of a series that has ended before the other, what it was.
  std::array<uint32_t, 2> samples_ = {};
  std::array<bool, 2> ended_ = {};
  uint32_t done_ = 0;  ///< Samples of each pixel that each series has.
  bool missed_ = false;
};

}  // namespace candela
