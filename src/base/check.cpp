#include "base/check.h"

#include <cstdio>
#include <cstdlib>

namespace candela {

void CheckFailed(const char* condition, const char* file, int line) {
  std::fprintf(stderr, "%s:%d: internal error: the condition '%s' does not hold\n", file, line,
               condition);
  std::abort();
}

}  // namespace candela
