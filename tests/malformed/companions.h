#pragma once

#include <filesystem>

namespace candela {

/// Makes what the scenes of the set name and text files cannot be, in a copy of the set: in
/// `files/` a folder, a pipe, a device and a broken link, in `cube_maps/` a folder of faces for
/// each defect that a picture can have.
void MakeCompanions(const std::filesystem::path& set);

}  // namespace candela
