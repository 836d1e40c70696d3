#include "loaders/course/place_of.h"

#include <system_error>

namespace candela {
namespace fs = std::filesystem;

fs::path PlaceOf(const fs::path& path) {
  std::error_code error;
  const fs::path place = fs::weakly_canonical(fs::absolute(path, error), error);
  return error ? path : place;
}

}  // namespace candela
