#pragma once

#include <algorithm>
#include <optional>

#include "base/clock.h"

namespace candela {

/// How long work may go on; counts from `Start`, or from its construction.
class TimeLimit {
 public:
  /// Nothing: for ever.
  explicit TimeLimit(std::optional<double> seconds) : seconds_(seconds) {}

  void Start() { clock_ = Stopwatch(); }
  bool IsOver() const { return seconds_ && clock_.Seconds() >= *seconds_; }
  /// What part of the time is over; 0 without a limit. Less than 1, since what has to be done all
  /// the same may take longer.
  double Progress() const { return seconds_ ? std::min(0.99, clock_.Seconds() / *seconds_) : 0; }

 private:
  std::optional<double> seconds_;
  Stopwatch clock_;
};

}  // namespace candela
