// Compiled with the flags of this instruction set: see CMakeLists.txt. Nothing here may leave a
// function behind that code for other processors shares; tests/kernel/isa_symbols_test.cmake looks.
#include "kernel/simd/avx512.h"

#include "kernel/isa/functions.h"

namespace candela::kernel {

const IsaFunctions kAvx512Functions = FunctionsFor<avx512::IsaLanes<8>>();
const IsaFunctions kAvx512x16Functions = FunctionsFor<avx512::IsaLanes<16>>();

}  // namespace candela::kernel
