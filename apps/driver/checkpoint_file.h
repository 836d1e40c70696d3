#pragma once

#include <filesystem>

#include "base/clock.h"
#include "base/result.h"
#include "render/checkpoint.h"
#include "render/render_job.h"

namespace candela {

/// The file in which a render is kept, so that it can go on another time.
class CheckpointFile {
 public:
  /// Saved at most every `seconds` while the job runs. The job has to outlive it.
  CheckpointFile(std::filesystem::path path, CheckpointOwner owner, double seconds, RenderJob* job)
      : path_(std::move(path)), owner_(std::move(owner)), seconds_(seconds), job_(*job) {}

  /// Goes on with what the file holds, if there is one.
  Result<void> Load();
  /// Writes the file anew, at once or not at all.
  Result<void> Save();
  /// The same, but only when the last time is long enough ago.
  Result<void> SaveWhenDue();

 private:
  std::filesystem::path path_;
  CheckpointOwner owner_;
  double seconds_;
  RenderJob& job_;
  Stopwatch since_saved_;
};

}  // namespace candela
