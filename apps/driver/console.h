#pragma once

#include <string_view>

#include "base/result.h"

namespace candela {

/// Prints a result on stdout. The exit status: 0, or that of an output that cannot be written after
/// a message that says so.
int PrintResult(std::string_view text);

/// Prints "where: error: message" on stderr and returns the exit status that belongs to the error.
int PrintError(std::string_view where, const Error& error);

/// Prints "where: warning: message" on stderr.
void PrintWarning(std::string_view where, std::string_view message);

}  // namespace candela
