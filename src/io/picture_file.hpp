#pragma once

// Pictures as files for people: the format follows the name's ending.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.hpp"
#include "io/image.hpp"

namespace facet::io {

enum class PictureFormat : uint8_t { png, jpeg, webp, avif, exr };

struct PictureFormatRow {
  PictureFormat format;
  std::string_view name, ending, otherEnding;  // "JPEG", ".jpg", ".jpeg"; no other: empty
  int longest;                                 // pixels of a side; 0: as many as memory holds
  bool alpha, deep, lossy;                     // holds transparency, 16 bits a channel, and loses what quality says
};
std::span<const PictureFormatRow> pictureFormats();
const PictureFormatRow& rowOf(PictureFormat format);

// By the ending, capitals or not; none: another one.
std::optional<PictureFormat> pictureFormat(const std::filesystem::path& path);
// By a word: "png", "jpg".
std::optional<PictureFormat> pictureFormatNamed(std::string_view word);
// ".png, .jpg, .webp, .avif or .exr" of those of display values, or of all.
std::string pictureEndings(bool exr);

// Display values as bytes. quality: of JPEG, WebP and AVIF, 1 to 100; 100 loses nothing in WebP and AVIF. JPEG without
// subsampling of its colours from 90 on. The same pixels give the same bytes. Errors: the format (no EXR) does not hold
// such pixels, or the library for AVIF is not installed.
Result<std::vector<uint8_t>> encodePicture(PictureFormat format, const Pixels& pixels, int quality,
                                           const std::string& name);

// The same into a file, whole or not at all (base/whole_file.hpp), or to standard output ("-").
Result<void> writePicture(const std::filesystem::path& path, PictureFormat format, const Pixels& pixels, int quality);

// Before anything is drawn: the format holds pictures of that size.
Result<void> checkPictureSize(PictureFormat format, int width, int height, const std::string& name);

}  // namespace facet::io
