#pragma once

// Colour images: PNG, JPEG, WebP, AVIF and KTX2 in (header checked against the pixel budget before anything is
// decoded), PNG out.

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "io/gltf.hpp"
#include "scene/model.hpp"

namespace facet::io {

// Row 0 is the top. Samples are interleaved, 8 bit or 16 bit (native byte order) each.
struct Pixels {
  int width = 0, height = 0;
  int channels = 0;        // 1 grey, 2 grey + alpha, 3 RGB, 4 RGBA
  int bytesPerSample = 1;  // 1 or 2
  std::vector<uint8_t> data;
  bool placeholder = false;  // the image was missing or corrupt
  std::string flaw = {};     // not empty: read in spite of damage, so that a part may look wrong; what the decoder says

  // KTX2, and remarks of AVIF, too:
  std::vector<std::vector<uint8_t>> levels = {};  // mip levels 1, 2, ... as the file has them; others are to be made
  enum class Transfer : uint8_t { unknown, linear, srgb };
  Transfer transfer = Transfer::unknown;  // what the file says that its colours are
  std::vector<std::string> remarks = {};  // what is unusual, and how it is shown
};

// Errors: no such format, over a limit, damaged (in part, too), no memory.
Result<Pixels> decodeImage(std::span<const uint8_t> encoded, const std::string& name, const Limits& limits = {});

// Decodes images[i] of the model in parallel where wanted[i]; the rest stay empty (width 0). A missing or corrupt image
// becomes its fallback's pixels (scene::Image) or else a conspicuous placeholder, and a warning that names it; one that
// is damaged in part, or whose curve is not that of its use, is a warning.
std::vector<Pixels> decodeImages(const scene::Model& model, const std::vector<bool>& wanted, Notes& notes,
                                 const Limits& limits = {});

// What an image's header says.
struct ImageInfo {
  std::string format;  // "PNG", "KTX2 (UASTC, Zstandard)"
  int width = 0, height = 0, channels = 0, bytesPerSample = 1;
  int levels = 1;            // mip levels in the file
  std::string problem = {};  // not empty: it cannot be read
};

ImageInfo describeImage(std::span<const uint8_t> encoded, const Limits& limits = {});
// Of the model's images; nothing is decoded.
std::vector<ImageInfo> describeImages(const scene::Model& model, const Limits& limits = {});

Pixels placeholderImage();  // magenta and black checks

// What a PNG says about itself (tEXt).
struct PngText {
  std::string keyword;  // 1 to 79 characters of Latin-1
  std::string text;
};

// 8-bit RGB or RGBA by all cores, the same bytes for the same pixels and texts; whole or not at all
// (base/whole_file.hpp). Errors: the file cannot be written.
Result<void> writePng(const std::filesystem::path& path, const Pixels& pixels, std::span<const PngText> texts = {});

// The text of that keyword; empty where there is none, or no PNG.
std::string readPngText(const std::filesystem::path& path, std::string_view keyword, const Limits& limits = {});

// A small one into memory; `name` leads the error.
Result<std::vector<uint8_t>> encodePng(const Pixels& pixels, const std::string& name);

// 8-bit PNG read back as RGBA (for compare). Errors as decodeImage.
Result<Pixels> readImage(const std::filesystem::path& path, const Limits& limits = {});

}  // namespace facet::io
