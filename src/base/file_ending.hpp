#pragma once

#include <filesystem>
#include <string>

namespace facet {

// What a name ends in, in small letters: ".png" of "a/B.PNG"; empty: it has no ending.
std::string fileEnding(const std::filesystem::path& path);

}  // namespace facet
