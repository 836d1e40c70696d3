#pragma once

// Everything an embedding program needs, in the order in which one usually meets it. Link
// `Candela::candela`; examples/embed is a complete program.

#include "base/diagnostics.h"
#include "base/files.h"
#include "base/parallel.h"
#include "base/result.h"
