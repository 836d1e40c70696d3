#pragma once

#include <string>
#include <vector>

#include "base/result.h"
#include "driver/render_request.h"
#include "image/exr.h"
#include "render/checkpoint.h"
#include "scene_spec/scene_spec.h"

namespace candela {

/// A name for the content of all files of a scene, wherever they lie: the 64-bit XXH3 of Y. Collet
/// over their sizes and bytes, in the order in which the scene names them. Fails when a file has
/// gone since it was loaded.
Result<std::string> HashScene(const SceneSpec& spec);

/// Whose checkpoint a render may go on with.
CheckpointOwner OwnerOfCheckpoint(const RenderRequest& request, std::string scene_hash);

/// What a picture depends on beside the scene and the number of samples, as options of a command
/// line, whether or not they were given.
std::string PictureOptions(const RenderRequest& request);

/// How a picture came to be, for its file. There is no time in it: the same picture is to have the
/// same bytes.
std::vector<ExrAttribute> PictureAttributes(const RenderRequest& request,
                                            const std::string& scene_hash);

}  // namespace candela
