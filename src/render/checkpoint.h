#pragma once

#include <string>
#include <string_view>

#include "base/result.h"
#include "render/render_job.h"

namespace candela {

/// To what a checkpoint belongs: it can be continued where all of this is the same.
struct CheckpointOwner {
  std::string version;  ///< Of the program; another one may draw other samples.
  std::string scene;    ///< Names the content of the scene's files.
  std::string options;  ///< All that a sample depends on; not how many there are.
};

/// The bytes of a file that holds what a job that keeps sums has rendered so far, with a checksum.
/// Not while the job runs, apart from its `after_pass`.
std::string EncodeCheckpoint(const RenderJob& job, const CheckpointOwner& owner);

/// Lets a job go on from there: what it renders then has the bytes of a render without a pause. An
/// error, and the job is as it was, when the file is no checkpoint, truncated or damaged, belongs
/// to somebody else, or holds more samples than the job is to render.
Result<void> DecodeCheckpoint(std::string_view bytes, const CheckpointOwner& owner, RenderJob* job);

}  // namespace candela
