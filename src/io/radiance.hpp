#pragma once

// Scene-linear images: Radiance .hdr and OpenEXR in, OpenEXR out.

#include <filesystem>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "io/gltf.hpp"
#include "scene/environment.hpp"

namespace facet::io {

// Linear Rec. 709, associated alpha, row 0 = top.
struct RadianceImage {
  int width = 0, height = 0;
  std::vector<glm::vec4> pixels;
};

// .hdr (RGBE, old and new scanlines) or .exr (by content, not by name); alpha 1 where the file has none. Values as
// stored: NaN and Inf may occur in EXR. Only the data window is read, placed in the display window; the rest is 0.
Result<RadianceImage> readRadiance(const std::filesystem::path& path, const Limits& limits = {});

// As readRadiance, then mended (scene::mend). Any size is accepted; a note says when it is not 2:1.
Result<scene::Environment> loadEnvironment(const std::filesystem::path& path, Notes& notes, const Limits& limits = {});

// 32-bit float RGBA. Errors: the file cannot be written.
Result<void> writeExr(const std::filesystem::path& path, const RadianceImage& image);

}  // namespace facet::io
