#pragma once

#include <string>

#include "results.h"

namespace candela {

/// All tables in Markdown, since they go to docs/performance.md.
std::string Tables(const BenchResult& result);

/// The first of them alone.
std::string ShortTable(const BenchResult& result);

/// Everything that was measured.
std::string Json(const BenchResult& result);

}  // namespace candela
