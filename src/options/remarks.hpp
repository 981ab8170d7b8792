#pragma once

// What became of a picture's options, told by their names.

#include <string>

#include "base/error.hpp"
#include "frame/picture.hpp"

namespace facet::options {

struct Remarks {
  std::string reached;  // behind the picture's name: ": 64 samples, error up to 0.8 %"; empty where there is nothing
  Notes notes;          // where it is not what was asked for
};
// radiance: it alone was drawn, for an EXR.
Remarks remarksOn(const frame::PictureSettings& settings, const frame::PictureStatistics& statistics, bool radiance);

}  // namespace facet::options
