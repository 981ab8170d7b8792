#pragma once

// Two models in the place of two pictures: both are drawn alike, and then compared.

#include <string>
#include <vector>

#include "base/error.hpp"
#include "base/origin.hpp"
#include "base/sandbox.hpp"
#include "frame/settings.hpp"
#include "io/image.hpp"

namespace facet::commands {

// By its name: builtin:..., or a file that ends in .glb or .gltf.
bool isModelSource(const std::string& source);

// Options of a picture that such a comparison takes: all but those that compare has, too, and of its programs.
std::vector<std::string_view> comparedOptions();

struct DrawnModels {
  io::Pixels first, second;          // as one sees them
  std::vector<std::string> changes;  // scene::changesBetween
  Origin origin;
};

struct ModelPair {
  std::string first, second;
  frame::PictureSettings settings;  // of both pictures
  Needed needed;                    // of the file system, besides
  bool sandbox = true;
};

// Both from the same place: where the settings leave it open, one that frames the second model as well as the first,
// and under the first one's environment. Warnings go to the log. noOpenGL: the error is that there is none.
Result<DrawnModels> drawModels(ModelPair pair, bool& noOpenGL);

}  // namespace facet::commands
