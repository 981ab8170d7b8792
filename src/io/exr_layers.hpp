#pragma once

// Which of an OpenEXR file's channels are the picture. Internal to io/.

#include <string>
#include <vector>

#include "base/error.hpp"

namespace facet::io {

enum class ExrColor { rgb, luminanceChroma, grey };

// Channels prefix + "R", "G", "B" (or "Y" alone, or "Y", "RY", "BY") of one part.
struct ExrLayer {
  size_t part = 0;
  std::string prefix;  // "" or "layer."
  std::string name;    // of part and prefix, for people: "rgba", "ViewLayer.Combined"; may be empty
  ExrColor color = ExrColor::rgb;
  bool alpha = false;
};

struct ExrPartChannels {
  std::string name;  // of the part; empty where there is one
  std::vector<std::string> channels;
};

// All of the file's, in its order (OpenEXR sorts channels by name).
std::vector<ExrLayer> exrLayers(const std::vector<ExrPartChannels>& parts);

// wanted: a layer's whole name or its last part; empty: the picture's own, which is in a file of one part the one
// without a prefix, else the first one called Combined, beauty, rgba, rgb, C, color or image, else the first part's
// without a prefix, else the first. Errors (file left empty): no layer has colours; none is called so.
Result<ExrLayer> chooseExrLayer(const std::vector<ExrPartChannels>& parts, const std::string& wanted);

}  // namespace facet::io
