#pragma once

#include <tuple>

#include "materials/medium.h"

namespace candela {

/// What is behind the surface of an object that light can get into.
struct Interior {
  Medium medium;
  /// Where bodies overlap, the medium is that of the greatest priority, and of several with the
  /// same that of the body that light has got into last.
  int priority = 0;
  /// The scene says what fills the object. Otherwise only its material does: then its surface is
  /// never hidden by other bodies, it refracts as it does in air, and others in it do so, too.
  bool is_explicit = false;

  /// As surfaces of other bodies see it.
  const Medium& SeenMedium() const { return is_explicit ? medium : kAir; }

  /// Interiors that have the same one are the same: a body may have several objects as its surface.
  auto Key() const { return std::tuple(medium.Key(), priority, is_explicit); }
};

}  // namespace candela
