#include "io/exr_header.hpp"

#include <ImfCompression.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include "io/little_endian.hpp"

namespace facet::io {

namespace {

using Bytes = std::span<const uint8_t>;

// Channels one after another: name, 0, type, linearity and padding (4), samplings; a 0 ends the list.
double bytesPerPixel(Bytes list) {
  double bytes = 0;
  for (size_t at = 0; at < list.size() && list[at] != 0;) {
    while (at < list.size() && list[at] != 0) ++at;
    if (list.size() - at < 17) break;
    const double size = littleEndian(list, at + 1) == 1 ? 2 : 4;  // half; unsigned and float
    const double samplings = double(littleEndian(list, at + 9)) * double(littleEndian(list, at + 13));
    if (samplings >= 1) bytes += size / samplings;
    at += 17;
  }
  return bytes;
}

// The library reads as much of these as the type has, whatever the header says, and goes on there.
constexpr std::string_view ofOneByte[] = {"compression", "deepImageState", "envmap", "lineOrder"};
constexpr std::pair<std::string_view, size_t> attributeSizes[] = {
    {"float", 4},    {"int", 4},   {"double", 8},   {"rational", 8},
    {"timecode", 8}, {"v2i", 8},   {"v2f", 8},      {"tiledesc", 9},
    {"v3i", 12},     {"v3f", 12},  {"box2i", 16},   {"box2f", 16},
    {"v2d", 16},     {"v3d", 24},  {"keycode", 28}, {"chromaticities", 32},
    {"m33f", 36},    {"m44f", 64}, {"m33d", 72},    {"m44d", 128}};

// Whether the library finds the next attribute where this one's size says.
bool endsWhereItSays(std::string_view type, Bytes value) {
  if (type == "preview")
    return value.size() >= 8 && static_cast<double>(value.size()) ==
                                    8 + 4.0 * double(littleEndian(value, 0)) * double(littleEndian(value, 4));
  if (type == "chlist") {
    size_t at = 0;
    while (at < value.size() && value[at] != 0) {
      while (at < value.size() && value[at] != 0) ++at;
      at += 17;
    }
    return at + 1 == value.size();
  }
  if (std::ranges::find(ofOneByte, type) != std::end(ofOneByte)) return value.size() == 1;
  const auto* known = std::ranges::find(attributeSizes, type, &std::pair<std::string_view, size_t>::first);
  return known == std::end(attributeSizes) || known->second == value.size();
}

void readAttribute(ExrPart& part, std::string_view name, std::string_view type, Bytes value) {
  const auto number = [&](size_t i) { return static_cast<int32_t>(littleEndian(value, 4 * i)); };
  if (type == "box2i" && value.size() == 16) {
    const ExrWindow window{number(0), number(1), number(2), number(3)};
    if (name == "dataWindow") part.data = window;
    if (name == "displayWindow") part.display = window;
  }
  if (name == "compression" && value.size() == 1) part.compression = value[0];
  if (name == "channels" && type == "chlist") part.bytesPerPixel = bytesPerPixel(value);
  if (name == "tiles" && value.size() >= 8) {
    part.tileWidth = littleEndian(value, 0);
    part.tileHeight = littleEndian(value, 4);
  }
}

// Scan lines in a chunk.
uint64_t linesPerChunk(int compression) {
  switch (compression) {
    case Imf::ZIP_COMPRESSION:
    case Imf::PXR24_COMPRESSION:
      return 16;
    case Imf::PIZ_COMPRESSION:
    case Imf::B44_COMPRESSION:
    case Imf::B44A_COMPRESSION:
    case Imf::DWAA_COMPRESSION:
      return 32;
    case Imf::DWAB_COMPRESSION:
      return 256;
    default:
      return 1;
  }
}

// The most that a byte of the file can become; infinite where only the number of chunks is a bound.
double largestRatio(int compression) {
  switch (compression) {
    case Imf::NO_COMPRESSION:
      return 1;
    case Imf::RLE_COMPRESSION:
      return 64;  // runs of 128 take two bytes
    case Imf::ZIPS_COMPRESSION:
    case Imf::ZIP_COMPRESSION:
      return 1040;  // deflate (zlib's manual: 1032)
    case Imf::PXR24_COMPRESSION:
      return 1400;  // deflate of three bytes in four
    case Imf::PIZ_COMPRESSION:
      return 600;  // Huffman runs: 256 numbers of two bytes in nine bits
    case Imf::B44_COMPRESSION:
    case Imf::B44A_COMPRESSION:
      return 11;  // blocks of 32 bytes in three
    default:
      return HUGE_VAL;
  }
}

uint64_t chunks(const ExrPart& part) {
  const uint64_t width = part.data->width(), height = part.data->height();
  const auto parts = [](uint64_t size, uint64_t of) { return (size + of - 1) / of; };
  if (part.tileWidth == 0 || part.tileHeight == 0) return parts(height, linesPerChunk(part.compression));
  return parts(width, part.tileWidth) * parts(height, part.tileHeight);
}

std::string sizeText(const ExrWindow& window) {
  return std::to_string(window.width()) + " x " + std::to_string(window.height());
}

Result<void> checkWindow(const std::optional<ExrWindow>& window, const char* what, const std::string& name,
                         const Limits& limits) {
  if (!window) return fail(name, "", std::string("the header has no ") + what, exrCopyAgain);
  const uint64_t width = window->width(), height = window->height();
  if (width == 0 || height == 0) return fail(name, "", std::string("the ") + what + " is empty", exrCopyAgain);
  if (height > limits.radiancePixels / width) {
    return fail(name, "",
                std::string("the ") + what + " has " + sizeText(*window) + " pixels, more than the limit of " +
                    std::to_string(limits.radiancePixels),
                "use a smaller picture");
  }
  return {};
}

}  // namespace

Result<std::vector<ExrPart>> scanExrParts(Bytes bytes, bool severalParts, const std::string& name) {
  std::vector<ExrPart> parts;
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  size_t at = 8;
  while (parts.empty() || (severalParts && at < bytes.size() && bytes[at] != 0)) {
    ExrPart& part = parts.emplace_back();
    while (at < bytes.size() && bytes[at] != 0) {
      const size_t nameEnd = text.find('\0', at);
      if (nameEnd == std::string_view::npos) return parts;
      const size_t typeEnd = text.find('\0', nameEnd + 1);
      if (typeEnd == std::string_view::npos || bytes.size() - typeEnd < 5) return parts;
      const size_t size = littleEndian(bytes, typeEnd + 1), value = typeEnd + 5;
      if (size > bytes.size() - value)  // the library would have the memory before it notices
        return fail(name, "byte " + std::to_string(typeEnd + 1),
                    "an attribute of " + std::to_string(size) + " bytes does not fit into the file", exrCopyAgain);
      const std::string_view type = text.substr(nameEnd + 1, typeEnd - nameEnd - 1);
      if (!endsWhereItSays(type, bytes.subspan(value, size)))
        return fail(name, "byte " + std::to_string(typeEnd + 1),
                    "an attribute of type " + std::string(type) + " has " + std::to_string(size) + " bytes",
                    exrCopyAgain);
      readAttribute(part, text.substr(at, nameEnd - at), type, bytes.subspan(value, size));
      at = value + size;
    }
    ++at;
  }
  return parts;
}

Result<void> checkExrPart(const ExrPart& part, uint64_t fileBytes, const std::string& name, const Limits& limits) {
  if (auto ok = checkWindow(part.data, "data window", name, limits); !ok) return ok;
  if (auto ok = checkWindow(part.display, "display window", name, limits); !ok) return ok;
  const double pixels = static_cast<double>(part.data->width()) * static_cast<double>(part.data->height());
  const double most = static_cast<double>(fileBytes) * largestRatio(part.compression);
  if (pixels * part.bytesPerPixel > most || chunks(part) > fileBytes / 16)
    return fail(name, "", "the file is too short for " + sizeText(*part.data) + " pixels", exrCopyAgain);
  // The library has the memory for a whole tile, however little of it there is.
  constexpr double usualTile = 1 << 20;
  if (double(part.tileWidth) * double(part.tileHeight) > std::max(usualTile, 4 * pixels))
    return fail(name, "",
                "its tiles have " + std::to_string(part.tileWidth) + " x " + std::to_string(part.tileHeight) +
                    " pixels, far more than the picture",
                exrCopyAgain);
  return {};
}

}  // namespace facet::io
