#pragma once

// What an OpenEXR file claims to hold, read from its bytes (OpenEXR File Layout) before the library, which allocates
// by the header's numbers, sees them. Internal to io/.

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "io/gltf.hpp"

namespace facet::io {

// What to do with a file that is damaged.
inline constexpr const char* exrCopyAgain = "copy or download it again";

struct ExrWindow {
  int64_t left = 0, top = 0, right = -1, bottom = -1;  // inclusive
  uint64_t width() const { return right < left ? 0 : static_cast<uint64_t>(right - left + 1); }
  uint64_t height() const { return bottom < top ? 0 : static_cast<uint64_t>(bottom - top + 1); }
};

// One part; a file of one part has one.
struct ExrPart {
  std::optional<ExrWindow> data, display;
  int compression = 0;                     // Imf::Compression
  double bytesPerPixel = 0;                // of all channels, before compression
  uint32_t tileWidth = 0, tileHeight = 0;  // 0: scan lines
};

// Stops where the bytes make no sense: the library says what is wrong. Errors: an attribute that is longer than the
// rest of the file.
Result<std::vector<ExrPart>> scanExrParts(std::span<const uint8_t> bytes, bool severalParts, const std::string& name);

// Errors: a window that is missing, empty or over the limit; more pixels than the file can hold, by its chunks (16
// bytes each at least) and by what its compression can shrink.
Result<void> checkExrPart(const ExrPart& part, uint64_t fileBytes, const std::string& name, const Limits& limits);

}  // namespace facet::io
