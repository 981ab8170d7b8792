#include "base/file_ending.hpp"

namespace facet {

std::string fileEnding(const std::filesystem::path& path) {
  std::string ending = path.extension().string();
  for (char& c : ending)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c + ('a' - 'A'));
  return ending;
}

}  // namespace facet
