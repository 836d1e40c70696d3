#pragma once

// Everything an embedding program needs, in the order in which one usually meets it. Link
// `Candela::candela`; examples/embed is a complete program.

#include "base/cancel_token.h"            // a request to stop
#include "base/diagnostics.h"             // what is wrong in the input
#include "base/files.h"                   // files that are replaced at once or not at all
#include "base/parallel.h"                // how many threads
#include "base/result.h"                  // how operations fail
#include "image/image_file.h"             // pictures as PNG, JPEG, EXR, HDR, PFM
#include "integrators/registry.h"         // ways to follow light
#include "loaders/course/scene_parser.h"  // scene text -> SceneSpec
#include "render/render_job.h"            // Scene -> Film
#include "scene/compile_scene.h"          // SceneSpec -> Scene
