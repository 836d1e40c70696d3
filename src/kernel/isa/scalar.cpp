#include "kernel/simd/scalar.h"

#include "kernel/isa/functions.h"

namespace candela::kernel {

const IsaFunctions kScalarFunctions = FunctionsFor<scalar::IsaLanes>();

}  // namespace candela::kernel
