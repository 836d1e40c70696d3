#include "base/isa.h"

#include <atomic>

#include "base/check.h"

namespace candela {
namespace {

struct IsaEntry {
  Isa isa;
  std::string_view name;
};
constexpr IsaEntry kIsas[] = {
    {Isa::kScalar, "scalar"}, {Isa::kAvx2, "avx2"}, {Isa::kAvx512, "avx512"}};

std::atomic<int> forced_isa = -1;

}  // namespace

bool IsSupported(Isa isa) {
  switch (isa) {
    case Isa::kScalar:
      return true;
#ifdef CANDELA_X86
    case Isa::kAvx2:
      return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
    case Isa::kAvx512:
      return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") &&
             __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
             __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512bw");
#else
    default:
      break;
#endif
  }
  return false;
}

Isa DefaultIsa() {
  const int forced = forced_isa.load(std::memory_order_relaxed);
  if (forced >= 0) return static_cast<Isa>(forced);
  if (IsSupported(Isa::kAvx512)) return Isa::kAvx512;
  return IsSupported(Isa::kAvx2) ? Isa::kAvx2 : Isa::kScalar;
}

void ForceIsa(Isa isa) {
  CHECK(IsSupported(isa));
  forced_isa.store(static_cast<int>(isa), std::memory_order_relaxed);
}

std::string_view IsaName(Isa isa) {
  for (const IsaEntry& entry : kIsas) {
    if (entry.isa == isa) return entry.name;
  }
  return {};
}

std::optional<Isa> FindIsa(std::string_view name) {
  for (const IsaEntry& entry : kIsas) {
    if (entry.name == name) return entry.isa;
  }
  return std::nullopt;
}

}  // namespace candela
