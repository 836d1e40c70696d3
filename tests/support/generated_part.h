#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace candela::testing_support {

/// The part of a document between the lines "<!-- begin: NAME -->" and "<!-- end: NAME -->" has to
/// be `expected`; with CANDELA_UPDATE=1 it is written instead. Fails the test otherwise, and where
/// there is no such part.
void ExpectGeneratedPart(const std::filesystem::path& document, std::string_view name,
                         const std::string& expected);

}  // namespace candela::testing_support
