#pragma once

#include <cstddef>
#include <utility>

namespace candela {

/// A large block of memory straight from the system, in large pages where there are any: random
/// reads then miss the address cache less often. Zeros at first; pages count as used once they are
/// written to.
class PageMemory {
 public:
  PageMemory() = default;
  /// Throws std::bad_alloc when the system has no room.
  explicit PageMemory(size_t bytes);
  ~PageMemory();
  PageMemory(PageMemory&& other) noexcept
      : data_(std::exchange(other.data_, nullptr)), size_(std::exchange(other.size_, 0)) {}
  PageMemory& operator=(PageMemory&& other) noexcept {
    std::swap(data_, other.data_);
    std::swap(size_, other.size_);
    return *this;
  }

  /// Aligned to a page. Null when empty.
  void* data() { return data_; }
  const void* data() const { return data_; }
  size_t size() const { return size_; }

 private:
  void* data_ = nullptr;
  size_t size_ = 0;
};

}  // namespace candela
