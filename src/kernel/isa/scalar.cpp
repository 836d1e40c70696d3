#include "kernel/simd/scalar.h"

#include "kernel/isa/functions.h"

namespace candela::kernel {

const TraceFunctions kScalarFunctions = FunctionsFor<scalar::IsaLanes>();

}  // namespace candela::kernel
