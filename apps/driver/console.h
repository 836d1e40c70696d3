#pragma once

#include <functional>
#include <string_view>

#include "base/result.h"

namespace candela {

/// Prints a result on stdout. An error when it does not arrive there.
Result<void> WriteResult(std::string_view text);

/// The same for a program that then ends: prints the error too, and returns the exit status.
int PrintResult(std::string_view program, std::string_view text);

/// Prints "where: error: message" on stderr and returns the exit status that belongs to the error.
int PrintError(std::string_view where, const Error& error);

/// The exit status of `run`, or that of a lack of memory, with a message, when there is one.
int RunWithinMemory(std::string_view program, const std::function<int()>& run);

/// Prints "where: warning: message" on stderr.
void PrintWarning(std::string_view where, std::string_view message);

}  // namespace candela
