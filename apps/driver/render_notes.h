#pragma once

#include <string>

#include "render/render_job.h"

namespace candela {

/// What the user should know of a picture that is done, as warnings on stderr: which samples were
/// dropped, whether bodies were left out, and how much light `--clamp` has taken away.
void PrintRenderNotes(const std::string& program, const RenderJob& job);

}  // namespace candela
