#include "io/hdr.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstring>
#include <optional>
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
  int width = 0, height = 0;                                    // of the picture
  bool columns = false, fromBottom = false, fromRight = false;  // how it is stored: column by column, from which ends
  double exposure = 1;
  glm::dvec3 correction = glm::dvec3(1);  // COLORCORR
  bool xyz = false;
  std::optional<optics::Chromaticities> primaries = {};
};

template <class T>
bool parseNumber(std::string_view text, T& value) {
  const auto isBlank = [](char c) { return c == ' ' || c == '\t'; };
  while (!text.empty() && isBlank(text.front())) text.remove_prefix(1);
  while (!text.empty() && isBlank(text.back())) text.remove_suffix(1);
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
  const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
  return code == std::errc() && end == text.data() + text.size();
}

// Numbers apart by blanks; nothing where there are more or fewer or one is none.
template <size_t N>
std::optional<std::array<double, N>> parseNumbers(std::string_view text) {
  std::array<double, N> numbers{};
  size_t count = 0;
  while (true) {
    const size_t begin = text.find_first_not_of(" \t");
    if (begin == std::string_view::npos) break;
    text.remove_prefix(begin);
    const size_t end = std::min(text.find_first_of(" \t"), text.size());
    if (count == N || !parseNumber(text.substr(0, end), numbers[count++])) return std::nullopt;
    text.remove_prefix(end);
  }
  if (count != N) return std::nullopt;
  return numbers;
}

// "-Y height +X width" of rows from the top; the other seven turn or mirror the picture.
Result<void> readResolution(HdrReader& reader, HdrHeader& header) {
  const size_t begin = reader.at;
  const std::string_view line = reader.line();
  reader.at = begin;
  const auto isAxis = [&](size_t at) {
    return at + 2 < line.size() && (line[at] == '+' || line[at] == '-') &&
           (line[at + 1] == 'X' || line[at + 1] == 'Y') && line[at + 2] == ' ';
  };
  size_t second = 3;
  while (second < line.size() && !isAxis(second)) ++second;
  if (!isAxis(0) || !isAxis(second) || line[1] == line[second + 1]) {
    return reader.error("the resolution line " + inQuotes(line) + " is not of the form \"-Y height +X width\"",
                        convertHdr);
  }
  header.columns = line[1] == 'X';
  int &first = header.columns ? header.width : header.height, &other = header.columns ? header.height : header.width;
  header.fromBottom = line[header.columns ? second : 0] == '+';
  header.fromRight = line[header.columns ? 0 : second] == '-';
  if (!parseNumber(line.substr(3, second - 3), first) || !parseNumber(line.substr(second + 3), other) || first <= 0 ||
      other <= 0) {
    return reader.error("the resolution line " + inQuotes(line) + " holds no positive size", convertHdr);
  }
  reader.line();
  return {};
}

// What the picture's lines say about its colours; each program on the way multiplied by its own.
Result<void> readVariable(HdrReader& reader, std::string_view line, size_t begin, HdrHeader& header) {
  constexpr std::string_view format = "FORMAT=", exposure = "EXPOSURE=", correction = "COLORCORR=",
                             primaries = "PRIMARIES=";
  const auto wrong = [&](std::string problem) {
    reader.at = begin;
    return reader.error(std::move(problem), convertHdr);
  };
  const auto positive = [](double value) { return value > 0 && std::isfinite(value); };
  if (line.starts_with(format)) {
    const std::string_view name = line.substr(format.size());
    header.xyz = name == "32-bit_rle_xyze";
    if (!header.xyz && name != "32-bit_rle_rgbe")
      return wrong("the pixel format " + inQuotes(name) + " is neither 32-bit_rle_rgbe nor 32-bit_rle_xyze");
  } else if (line.starts_with(exposure)) {
    double value = 0;
    if (!parseNumber(line.substr(exposure.size()), value) || !positive(value))
      return wrong(inQuotes(line) + " is not a positive number");
    header.exposure *= value;
  } else if (line.starts_with(correction)) {
    const auto values = parseNumbers<3>(line.substr(correction.size()));
    if (!values || !std::ranges::all_of(*values, positive))
      return wrong(inQuotes(line) + " is not three positive numbers");
    header.correction *= glm::dvec3((*values)[0], (*values)[1], (*values)[2]);
  } else if (line.starts_with(primaries)) {
    const auto v = parseNumbers<8>(line.substr(primaries.size()));
    if (!v) return wrong(inQuotes(line) + " is not eight numbers");
    header.primaries =
        optics::Chromaticities{{(*v)[0], (*v)[1]}, {(*v)[2], (*v)[3]}, {(*v)[4], (*v)[5]}, {(*v)[6], (*v)[7]}};
  }
  return {};
}

Result<HdrHeader> readHeader(HdrReader& reader) {
  HdrHeader header;
  reader.line();  // "#?RADIANCE"
  while (reader.at < reader.bytes.size()) {
    const size_t begin = reader.at;
    const std::string_view line = reader.line();
    if (line.empty()) {
      if (auto ok = readResolution(reader, header); !ok) return tl::unexpected(ok.error());
      return header;
    }
    if (auto ok = readVariable(reader, line, begin, header); !ok) return tl::unexpected(ok.error());
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

// Old runs hold any number of pixels, the new ones up to 16 a byte. Small pictures of one colour may have what they
// like.
constexpr uint64_t freeHdrPixels = uint64_t{1} << 22, hdrPixelsPerByte = 64;

// Factor of a mantissa by exponent; e = 0 means black.
std::array<float, 256> exponentTable(double exposure) {
  std::array<float, 256> table{};
  for (int e = 1; e < 256; ++e) table[static_cast<size_t>(e)] = static_cast<float>(std::ldexp(1 / exposure, e - 136));
  return table;
}

// Rows from the top, each from the left.
void orient(RadianceImage& image, const HdrHeader& header) {
  if (!header.columns && !header.fromBottom && !header.fromRight) return;
  const auto width = static_cast<size_t>(header.width), height = static_cast<size_t>(header.height);
  const std::vector<glm::vec4> stored = std::move(image.pixels);
  image.pixels.resize(stored.size());
  for (size_t y = 0; y < height; ++y) {
    for (size_t x = 0; x < width; ++x) {
      const size_t row = header.fromBottom ? height - 1 - y : y, column = header.fromRight ? width - 1 - x : x;
      image.pixels[y * width + x] = stored[header.columns ? column * height + row : row * width + column];
    }
  }
}

void toRec709(RadianceImage& image, const HdrHeader& header) {
  if (header.correction != glm::dvec3(1)) {
    const glm::dvec3 c = 1.0 / header.correction;
    applyColorMatrix(image, glm::dmat3(c.x, 0, 0, 0, c.y, 0, 0, 0, c.z));
    image.notes.push_back({Note::Severity::info, "", "the colour correction that it names is taken back"});
  }
  if (header.xyz) {
    applyColorMatrix(image, optics::rec709FromXyz());
    image.notes.push_back({Note::Severity::info, "", "converted to Rec. 709 from CIE XYZ, Y as it is"});
  } else if (header.primaries) {
    io::toRec709(image, *header.primaries);
  }
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
  // As it is stored: scan lines and what each has.
  const auto width = static_cast<size_t>(header->columns ? header->height : header->width);
  const auto height = static_cast<size_t>(header->columns ? header->width : header->height);
  if (height > limits.radiancePixels / width) {
    return fail(name, "",
                "the picture has " + std::to_string(header->width) + " x " + std::to_string(header->height) +
                    " pixels, more than the limit of " + std::to_string(limits.radiancePixels),
                "use a smaller picture");
  }
  // No row takes less than one pixel and one run of 2^24, so a header cannot demand memory that no data backs.
  const uint64_t left = bytes.size() - reader.at;
  if (height > left / 4) return reader.error("the file is cut off", "copy or download it again");
  if (width * height > freeHdrPixels && width * height / hdrPixelsPerByte > left) {
    return reader.error(std::to_string(left) + " bytes are too few for " + std::to_string(header->width) + " x " +
                            std::to_string(header->height) + " pixels",
                        "copy or download it again");
  }

  RadianceImage image;
  image.width = header->width;
  image.height = header->height;
  image.pixels.reserve(width * height);  // filled row by row: of a damaged file only what was read takes memory
  const auto table = exponentTable(header->exposure);
  std::vector<uint8_t> row(width * 4);
  for (size_t y = 0; y < height; ++y) {
    const size_t begin = reader.at;
    if (!(isNewRow(reader, width) ? readNewRow(reader, width, row.data()) : readOldRow(reader, width, row.data()))) {
      reader.at = begin;
      return reader.error("row " + std::to_string(y) + " is damaged or cut off", "copy or download it again");
    }
    image.pixels.resize((y + 1) * width);
    glm::vec4* out = &image.pixels[y * width];
    const uint8_t *r = row.data(), *g = r + width, *b = g + width, *e = b + width;
    for (size_t x = 0; x < width; ++x) {
      const float f = table[e[x]];
      out[x] =
          glm::vec4(static_cast<float>(r[x]) * f, static_cast<float>(g[x]) * f, static_cast<float>(b[x]) * f, 1.0f);
    }
  }
  orient(image, *header);
  toRec709(image, *header);
  return image;
}

}  // namespace facet::io
