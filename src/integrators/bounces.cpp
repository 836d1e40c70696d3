#include "integrators/bounces.h"

#include <limits>

#include "integrators/registry.h"

namespace candela {
namespace {

constexpr uint32_t kUnlimited = std::numeric_limits<uint32_t>::max();

}  // namespace

BounceLimits::BounceLimits(const IntegratorOptions& options)
    : all(options.bounces.value_or(kUnlimited)),
      of_kind{options.diffuse_bounces.value_or(kUnlimited),
              options.mirror_bounces.value_or(kUnlimited),
              options.transmission_bounces.value_or(kUnlimited)} {}

}  // namespace candela
