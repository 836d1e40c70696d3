#pragma once

#include <string>

#include "image/raster.h"

namespace candela::testing_support {

/// True when the tests are to store what they measure instead of judging it: with CANDELA_UPDATE=1
/// in the environment (see docs/testing.md).
bool IsUpdate();

/// Stores three PNG files for whoever has to find out why a test of pictures fails: ours, the
/// reference, and where they differ, ten times as bright. They lie in the folder `failed` beside
/// the test program. Returns a message that names them.
std::string StoreForInspection(const std::string& name, const Image& ours, const Image& reference);

}  // namespace candela::testing_support
