#include "io/hdr.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <cstring>
#include <string_view>
#include <vector>

#include "io/uri.hpp"

namespace facet::io {

namespace {

using Bytes = std::span<const uint8_t>;

constexpr const char* convertHdr = "convert it to OpenEXR or to an ordinary .hdr";

struct HdrReader {
  Bytes bytes;
  const std::string& name;
  size_t at = 0;

  tl::unexpected<Error> error(std::string problem, std::string remedy) const {
    return fail(name, "byte " + std::to_string(at), std::move(problem), std::move(remedy));
  }
  // Without the line feed; the rest of the file where there is none.
  std::string_view line() {
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    const size_t end = std::min(text.find('\n', at), text.size());
    std::string_view result = text.substr(at, end - at);
    at = std::min(end + 1, text.size());
    if (result.ends_with('\r')) result.remove_suffix(1);
    return result;
  }
};

struct HdrHeader {
  int width = 0, height = 0;
  double exposure = 1;
};

template <class T>
bool parseNumber(std::string_view text, T& value) {
  while (text.starts_with(' ')) text.remove_prefix(1);
  while (text.ends_with(' ')) text.remove_suffix(1);
  const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
  return code == std::errc() && end == text.data() + text.size();
}

Result<void> readResolution(HdrReader& reader, HdrHeader& header) {
  const size_t begin = reader.at;
  const std::string_view line = reader.line();
  reader.at = begin;
  const size_t x = line.find("+X ");
  if (!line.starts_with("-Y ") || x == std::string_view::npos) {
    return reader.error("the resolution line " + inQuotes(line) + " is not of the form \"-Y height +X width\"",
                        convertHdr);
  }
  if (!parseNumber(line.substr(3, x - 3), header.height) || !parseNumber(line.substr(x + 3), header.width) ||
      header.width <= 0 || header.height <= 0) {
    return reader.error("the resolution line " + inQuotes(line) + " holds no positive size", convertHdr);
  }
  reader.line();
  return {};
}

Result<HdrHeader> readHeader(HdrReader& reader) {
  constexpr std::string_view format = "FORMAT=", exposure = "EXPOSURE=";
  HdrHeader header;
  reader.line();  // "#?RADIANCE"
  while (reader.at < reader.bytes.size()) {
    const size_t begin = reader.at;
    const std::string_view line = reader.line();
    if (line.empty()) {
      if (auto ok = readResolution(reader, header); !ok) return tl::unexpected(ok.error());
      return header;
    }
    if (line.starts_with(format) && line.substr(format.size()) != "32-bit_rle_rgbe") {
      reader.at = begin;
      return reader.error("the pixel format " + inQuotes(line.substr(format.size())) + " is not 32-bit_rle_rgbe",
                          convertHdr);
    }
    if (line.starts_with(exposure)) {
      double value = 0;
      if (!parseNumber(line.substr(exposure.size()), value) || !(value > 0) || !std::isfinite(value)) {
        reader.at = begin;
        return reader.error(inQuotes(line) + " is not a positive number", convertHdr);
      }
      header.exposure *= value;  // each program on the way multiplied by its own
    }
  }
  return reader.error("the file ends within its header", "copy or download it again");
}

// Run-length coded channel by channel (since 1991). `row` is planar: width bytes each of R, G, B, E.
bool readNewRow(HdrReader& reader, size_t width, uint8_t* row) {
  const Bytes bytes = reader.bytes;
  size_t at = reader.at + 4;
  for (uint8_t *out = row, *end = row + width * 4; out < end;) {
    // A run may not cross into the next channel.
    const size_t left = width - static_cast<size_t>(out - row) % width;
    if (at + 2 > bytes.size()) return false;
    const uint8_t code = bytes[at++];
    const size_t count = code > 128 ? code - 128u : code;
    if (count == 0 || count > left) return false;
    if (code > 128) {
      std::memset(out, bytes[at++], count);
    } else {
      if (count > bytes.size() - at) return false;
      std::memcpy(out, bytes.data() + at, count);
      at += count;
    }
    out += count;
  }
  reader.at = at;
  return true;
}

// Whole pixels; (1, 1, 1, n) repeats the last one n times, several in a row count as digits of 8 bits, lowest first.
bool readOldRow(HdrReader& reader, size_t width, uint8_t* row) {
  size_t filled = 0;
  int shift = 0;
  while (filled < width) {
    if (reader.at + 4 > reader.bytes.size()) return false;
    const uint8_t* pixel = reader.bytes.data() + reader.at;
    reader.at += 4;
    const bool run = pixel[0] == 1 && pixel[1] == 1 && pixel[2] == 1;
    if (!run) {
      for (size_t c = 0; c < 4; ++c) row[c * width + filled] = pixel[c];
      ++filled;
      shift = 0;
      continue;
    }
    if (shift > 16 || filled == 0) return false;
    const size_t count = static_cast<size_t>(pixel[3]) << shift;
    if (count > width - filled) return false;
    for (size_t c = 0; c < 4; ++c) {
      std::memset(row + c * width + filled, row[c * width + filled - 1], count);
    }
    filled += count;
    shift += 8;
  }
  return true;
}

bool isNewRow(const HdrReader& reader, size_t width) {
  const Bytes rest = reader.bytes.subspan(reader.at);
  return width >= 8 && width <= 32767 && rest.size() >= 4 && rest[0] == 2 && rest[1] == 2 && rest[2] < 128 &&
         (static_cast<size_t>(rest[2]) << 8 | rest[3]) == width;
}

// Factor of a mantissa by exponent; e = 0 means black.
std::array<float, 256> exponentTable(double exposure) {
  std::array<float, 256> table{};
  for (int e = 1; e < 256; ++e) table[static_cast<size_t>(e)] = static_cast<float>(std::ldexp(1 / exposure, e - 136));
  return table;
}

}  // namespace

bool isHdr(Bytes bytes) {
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  return text.starts_with("#?RADIANCE") || text.starts_with("#?RGBE");
}

Result<RadianceImage> decodeHdr(Bytes bytes, const std::string& name, const Limits& limits) {
  HdrReader reader{bytes, name};
  const auto header = readHeader(reader);
  if (!header) return tl::unexpected(header.error());
  const auto width = static_cast<size_t>(header->width), height = static_cast<size_t>(header->height);
  if (height > limits.radiancePixels / width) {
    return fail(name, "",
                "the picture has " + std::to_string(width) + " x " + std::to_string(height) +
                    " pixels, more than the limit of " + std::to_string(limits.radiancePixels),
                "use a smaller picture");
  }
  // No row takes less than one pixel and one run of 2^24, so a header cannot demand memory that no data backs.
  if (height > (bytes.size() - reader.at) / 4) return reader.error("the file is cut off", "copy or download it again");

  RadianceImage image;
  image.width = header->width;
  image.height = header->height;
  image.pixels.resize(width * height);
  const auto table = exponentTable(header->exposure);
  std::vector<uint8_t> row(width * 4);
  for (size_t y = 0; y < height; ++y) {
    const size_t begin = reader.at;
    if (!(isNewRow(reader, width) ? readNewRow(reader, width, row.data()) : readOldRow(reader, width, row.data()))) {
      reader.at = begin;
      return reader.error("row " + std::to_string(y) + " is damaged or cut off", "copy or download it again");
    }
    glm::vec4* out = &image.pixels[y * width];
    const uint8_t *r = row.data(), *g = r + width, *b = g + width, *e = b + width;
    for (size_t x = 0; x < width; ++x) {
      const float f = table[e[x]];
      out[x] =
          glm::vec4(static_cast<float>(r[x]) * f, static_cast<float>(g[x]) * f, static_cast<float>(b[x]) * f, 1.0f);
    }
  }
  return image;
}

}  // namespace facet::io
