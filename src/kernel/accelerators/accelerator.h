#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <utility>

#include "base/cancel_token.h"
#include "kernel/accelerator_kind.h"
#include "kernel/accelerators/entry_table.h"

namespace candela::kernel {

class EntrySearch;

/// What leads a ray to the entries that it may hit, in the place of the kernel's tree: simple
/// structures, to be read and compared. Immutable; called concurrently.
class Accelerator {
 public:
  explicit Accelerator(EntryTable table) : table_(std::move(table)) {}
  virtual ~Accelerator() = default;

  /// Lets `search` test the bounded entries that its ray may hit, any number of times each, best
  /// those near its beginning first. True when the search is over.
  virtual bool Walk(EntrySearch* search) const = 0;

  virtual uint64_t MemoryBytes() const { return table_.MemoryBytes(); }

  const EntryTable& table() const { return table_; }

 private:
  EntryTable table_;
};

/// Sorts the entries of a table by their boxes; `kind` is not `kBvh`. Memory and time are bounded
/// for any boxes. Throws when cancelled.
std::shared_ptr<const Accelerator> MakeAccelerator(AcceleratorKind kind, EntryTable table,
                                                   std::span<const Bounds3> boxes,
                                                   const CancelToken* cancel);

}  // namespace candela::kernel
