#pragma once

// An environment's tables as pictures, for other programs: `facet tables`.

#include <string>
#include <vector>

#include "base/error.hpp"
#include "io/radiance.hpp"
#include "report/table.hpp"
#include "scene/environment.hpp"
#include "shading/programs.hpp"

namespace facet::report {

struct TableImage {
  std::string name;  // "dfg", "sheen", "irradiance", "ld-0.30" (perceptual roughness), "environment"
  std::string holds, storedAs;
  io::RadianceImage image;
};
// All that a frame may read, by the usual methods, as the shaders read them but for the power of two that half floats
// may need. Cubes are their faces +X, -X, +Y, -Y, +Z, -Z below each other, each as OpenGL has it.
Result<std::vector<TableImage>> tableImages(const scene::Environment& environment, shading::ProgramStore& programs);

// What is in them: a row each.
Table tableImagesTable(const std::vector<TableImage>& images);

}  // namespace facet::report
