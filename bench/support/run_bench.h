#pragma once

#include <optional>
#include <span>

#include "base/result.h"
#include "driver/arg_parser.h"
#include "driver/console.h"

namespace candela {

/// What a benchmark does with its command line: reads it, and runs `run` unless that was all. The
/// exit status.
template <class Run>
int RunBench(ArgParser& parser, std::span<const char* const> words, Run run) {
  if (const std::optional<int> status = ReadCommandLine(parser, words)) return *status;
  const Result<void> done = run();
  return done ? 0 : PrintError(parser.program(), done.error());
}

}  // namespace candela
