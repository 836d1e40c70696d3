#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "base/diagnostics.h"

namespace candela {

/// Reports the first NUL byte, which no text has, at its place; true when there is one.
bool HasNul(const std::shared_ptr<const std::string>& file, std::string_view text,
            Diagnostics* diagnostics);

}  // namespace candela
