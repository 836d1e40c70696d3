#include "driver/checkpoint_file.h"

#include <string>

#include "base/files.h"
#include "driver/picture_files.h"

namespace candela {

Result<void> CheckpointFile::Load() {
  std::error_code ignored;
  if (!std::filesystem::exists(path_, ignored)) return {};
  const Result<std::string> bytes = ReadFile(path_);
  if (!bytes) return WithPath(path_, bytes.error());
  if (const auto done = DecodeCheckpoint(*bytes, owner_, &job_); !done) {
    return WithPath(path_, done.error());
  }
  return {};
}

Result<void> CheckpointFile::Save() {
  const auto written = WriteOutput(path_, EncodeCheckpoint(job_, owner_));
  since_saved_ = Stopwatch();
  return written;
}

Result<void> CheckpointFile::SaveWhenDue() {
  return since_saved_.Seconds() < seconds_ ? Result<void>() : Save();
}

}  // namespace candela
