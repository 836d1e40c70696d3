#pragma once

#include <optional>
#include <string_view>

namespace candela {

/// The instruction sets that there is code for: in the ray kernel and in the sampler. All give the
/// same bits.
enum class Isa { kScalar, kAvx2, kAvx512 };

/// Whether this processor, and its system, can run it.
bool IsSupported(Isa isa);

/// The best one that is supported, or the one that was forced.
Isa DefaultIsa();

/// Makes `DefaultIsa` return `isa`, which has to be supported; for tests and for `--isa`. Call
/// it before anything is built: groups keep the one that they were built for.
void ForceIsa(Isa isa);

/// "scalar", "avx2", "avx512".
std::string_view IsaName(Isa isa);
std::optional<Isa> FindIsa(std::string_view name);

}  // namespace candela
