#pragma once

// Scene-linear images: Radiance .hdr and OpenEXR in, OpenEXR out.

#include <filesystem>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "base/origin.hpp"
#include "io/gltf.hpp"
#include "optics/color_space.hpp"
#include "scene/environment.hpp"

namespace facet::io {

// Linear Rec. 709, associated alpha, row 0 = top.
struct RadianceImage {
  int width = 0, height = 0;
  std::vector<glm::vec4> pixels;
  Notes notes = {};  // of reading it, without a place
};

// .hdr (RGBE, XYZE, old and new scanlines) or .exr (by content, not by name); alpha 1 where the file has none. NaN and
// Inf may occur in EXR; colours outside of Rec. 709 are negative. Only the data window is read, placed in the display
// window; the rest is 0. layer: of an EXR (decodeExr).
Result<RadianceImage> readRadiance(const std::filesystem::path& path, const Limits& limits = {},
                                   const std::string& layer = {});

// From the primaries that the file says its colours have; a note says so, a warning where they span nothing: the
// colours are then taken as they are. NaN and Inf stay.
void toRec709(RadianceImage& image, const optics::Chromaticities& primaries);

// rgb of each pixel whose result is finite.
void applyColorMatrix(RadianceImage& image, const glm::dmat3& matrix);

// As readRadiance, then mended (scene::mend). Any size is accepted; a note says when it is not 2:1.
Result<scene::Environment> loadEnvironment(const std::filesystem::path& path, Notes& notes, const Limits& limits = {},
                                           const std::string& layer = {});

// 32-bit float RGBA, whole or not at all (base/whole_file.hpp; "-" is standard output), with what is known of its
// origin as attributes of the header, and layers: channels "error.R" and so on. Errors: the file cannot be written.
struct ExrLayerImage {
  std::string name;
  const RadianceImage* image;      // of the picture's size
  std::string components = "RGB";  // a letter for each of the image's numbers that is written
};
Result<void> writeExr(const std::filesystem::path& path, const RadianceImage& image, const Origin& origin = {},
                      const std::vector<ExrLayerImage>& layers = {});

}  // namespace facet::io
