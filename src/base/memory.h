#pragma once

#include <cstdint>

namespace candela {

/// Bytes that this process may still allocate: the smaller of the memory the system has available
/// and what the control group leaves; the largest number where the system does not tell.
uint64_t AvailableMemory();

/// The largest resident size that this process has had, in bytes; 0 where the system does not tell.
uint64_t PeakMemory();

}  // namespace candela
