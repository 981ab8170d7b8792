#pragma once

#include <span>
#include <string>

#include "io/image.hpp"

namespace facet::compare {

struct Titled {
  std::string title;  // in Latin letters
  io::Pixels picture;
};

// RGB: the pictures in rows of `columns`, each below its title. What lets shine through lies on grey. Pictures may have
// 1 to 4 channels of 8 bits and differ in size: each stands at the upper left of its place.
io::Pixels sideBySide(std::span<const Titled> pictures, int columns);

}  // namespace facet::compare
