// Compiled with the flags of this instruction set: see CMakeLists.txt. Nothing here may leave a
// function behind that code for other processors shares; tests/kernel/isa_symbols_test.cmake looks.
#include "kernel/simd/avx2.h"

#include "kernel/isa/functions.h"

namespace candela::kernel {

const IsaFunctions kAvx2Functions = FunctionsFor<avx2::IsaLanes>();

}  // namespace candela::kernel
