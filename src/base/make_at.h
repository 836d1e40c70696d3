#pragma once

#include <new>
#include <type_traits>

namespace candela {

/// Puts what `make` returns into `place`, whose object needs no destructor, without the copy that
/// an assignment takes: a copy of what has just been stored in parts has to wait for them.
template <class T, class Make>
void MakeAt(T* place, const Make& make) {
  static_assert(std::is_trivially_destructible_v<T>);
  ::new (place) T(make());
}

}  // namespace candela
