#pragma once

#include <cstddef>
#include <utility>

#include "base/page_memory.h"
#include "kernel/record.h"

namespace candela::kernel {

/// The records of a tree, on large pages where the system has them. Zeros at first.
class Arena {
 public:
  Arena() = default;
  /// Room for `count` records; memory is taken from the system when it is written to. Throws
  /// std::bad_alloc.
  explicit Arena(size_t count) : memory_(count * sizeof(Record)) {}

  Record* data() { return static_cast<Record*>(memory_.data()); }
  const Record* data() const { return static_cast<const Record*>(memory_.data()); }
  size_t size() const { return memory_.size() / sizeof(Record); }

  /// Gives back what lies behind the first `count` records.

 private:
  PageMemory memory_;
};

}  // namespace candela::kernel
