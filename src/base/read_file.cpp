#include <cerrno>
#include <cstring>
#include <fstream>
#include <new>
#include <system_error>

#include "base/files.h"
#include "base/memory.h"

namespace candela {
namespace fs = std::filesystem;
namespace {

const char* KindOf(fs::file_type type) {
  switch (type) {
    case fs::file_type::directory:
      return "is a folder";
    case fs::file_type::block:
    case fs::file_type::character:
      return "is a device";
    case fs::file_type::fifo:
      return "is a pipe";
    case fs::file_type::socket:
      return "is a socket";
    default:
      return "is not a regular file";
  }
}

}  // namespace

Result<std::string> ReadFile(const fs::path& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (status.type() == fs::file_type::not_found) return Error{ErrorCode::kInput, "no such file"};
  if (error) return Error{ErrorCode::kInput, error.message()};
  if (!fs::is_regular_file(status)) {
    return Error{ErrorCode::kInput, std::string(KindOf(status.type())) + ", not a file"};
  }

  errno = 0;
  std::ifstream stream(path, std::ios::binary);
  if (!stream) return Error{ErrorCode::kInput, std::strerror(errno)};
  const uintmax_t size = fs::file_size(path, error);
  if (error) return Error{ErrorCode::kInput, error.message()};

  // A system that promises more memory than it has would end the process while the bytes arrive.
  constexpr uintmax_t kSmall = 64 << 20;  // not worth asking
  if (size > kSmall && size > AvailableMemory()) {
    return Error{ErrorCode::kResources, "does not fit into memory"};
  }
  std::string content;
  try {
    content.resize(size);
  } catch (const std::exception&) {
    return Error{ErrorCode::kResources, "does not fit into memory"};
  }
  stream.read(content.data(), static_cast<std::streamsize>(size));
  // A file that is cut while it is read ends early; what is there is what will be judged.
  content.resize(static_cast<size_t>(stream.gcount()));
  if (stream.bad()) return Error{ErrorCode::kInput, "cannot be read"};
  return content;
}

}  // namespace candela
