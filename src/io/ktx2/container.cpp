#include "io/ktx2/container.hpp"

#include <algorithm>
#include <bit>
#include <cstring>
#include <limits>
#include <string_view>

#include "io/image_formats.hpp"
#include "io/little_endian.hpp"

namespace facet::io {

namespace {

using Bytes = std::span<const uint8_t>;

constexpr uint8_t identifier[] = {0xAB, 'K', 'T', 'X', ' ', '2', '0', 0xBB, '\r', '\n', 0x1A, '\n'};  // 3.1
constexpr size_t headerBytes = 80, levelIndexBytes = 24;

uint64_t wideLittleEndian(Bytes bytes, size_t at) {
  return littleEndian(bytes, at) | static_cast<uint64_t>(littleEndian(bytes, at + 4)) << 32;
}

tl::unexpected<Error> damaged(const std::string& what) {
  return fail("", "", "the KTX2 file is damaged: " + what, "save it again");
}
tl::unexpected<Error> otherTexture(const std::string& what) {
  return fail("", "", "is " + what + ", and only plain 2D textures are shown", "save a 2D texture");
}

Result<Bytes> part(Bytes bytes, uint64_t offset, uint64_t length, const std::string& what) {
  if (offset > bytes.size() || length > bytes.size() - offset) return damaged(what + " lies outside the file");
  return bytes.subspan(static_cast<size_t>(offset), static_cast<size_t>(length));
}

// 3.2 to 3.9
Result<void> readSizes(Bytes bytes, Ktx2& ktx, size_t& levelCount) {
  const uint32_t width = littleEndian(bytes, 20), height = littleEndian(bytes, 24), depth = littleEndian(bytes, 28);
  const uint32_t layers = littleEndian(bytes, 32), faces = littleEndian(bytes, 36), levels = littleEndian(bytes, 40);
  if (width == 0) return damaged("its width is 0");
  if (height == 0) return otherTexture("a 1D KTX2 texture");
  if (depth != 0) return otherTexture("a 3D KTX2 texture");
  if (layers != 0) return otherTexture("an array of " + std::to_string(layers) + " KTX2 textures");
  if (faces != 1) return otherTexture("a KTX2 texture of " + std::to_string(faces) + " faces");
  constexpr uint32_t most = std::numeric_limits<int>::max();
  if (width > most || height > most)
    return damaged("it has " + std::to_string(width) + " x " + std::to_string(height) + " texels");
  const auto mostLevels = static_cast<uint32_t>(std::bit_width(std::max(width, height)));
  if (levels > mostLevels)
    return damaged("it has " + std::to_string(levels) + " mip levels, and " + std::to_string(mostLevels) +
                   " is the most");
  ktx.width = static_cast<int>(width);
  ktx.height = static_cast<int>(height);
  levelCount = std::max(1u, levels);  // 0: the reader is to make the others
  return {};
}

// 3.10: the levels' places
Result<void> readLevels(Bytes bytes, Ktx2& ktx, size_t count) {
  if (bytes.size() < headerBytes + count * levelIndexBytes) return damaged("it ends within its index");
  for (size_t i = 0; i < count; ++i) {
    const size_t at = headerBytes + i * levelIndexBytes;
    const auto level =
        part(bytes, wideLittleEndian(bytes, at), wideLittleEndian(bytes, at + 8), "level " + std::to_string(i));
    if (!level) return tl::unexpected(level.error());
    if (level->empty()) return damaged("level " + std::to_string(i) + " is empty");
    ktx.levels.push_back({*level, wideLittleEndian(bytes, at + 16)});
  }
  return {};
}

// 3.11: its first, basic descriptor block
Result<void> readDescriptor(Bytes bytes, Ktx2& ktx) {
  const auto block = part(bytes, littleEndian(bytes, 48), littleEndian(bytes, 52), "the data format descriptor");
  if (!block) return tl::unexpected(block.error());
  constexpr size_t basicBytes = 4 + 24, sampleBytes = 16;
  if (block->size() < basicBytes) return damaged("its data format descriptor is too short");
  const size_t size = littleEndian(*block, 8) >> 16;
  if ((littleEndian(*block, 4) != 0) || size < 24 || size > block->size() - 4)
    return damaged("its data format descriptor is none");
  ktx.model = static_cast<ColorModel>((*block)[12]);
  ktx.primaries = (*block)[13];
  ktx.transfer = (*block)[14];
  ktx.premultiplied = (*block)[15] & 1;
  for (size_t at = basicBytes; at + sampleBytes <= 4 + size; at += sampleBytes)
    ktx.channelIds.push_back((*block)[at + 3] & 15);
  return {};
}

// 5.2: how whoever made it saw it. The first texel lies at the origin of the texture coordinates whatever it says.
void noteOrientation(std::string_view value, Ktx2& ktx) {
  if (value != "rd")
    ktx.remarks.push_back("its KTXorientation is not rd: its first row is shown at the top all the same");
}

// 5.4
void setSwizzle(std::string_view value, Ktx2& ktx) {
  if (value.size() == 4 && value.find_first_not_of("rgba01") == std::string_view::npos)
    ktx.swizzle = value;
  else
    ktx.remarks.push_back("its KTXswizzle is none: it is shown without");
}

// 3.12: lengths, "key\0value", padding to 4
Result<void> readKeyValues(Bytes bytes, Ktx2& ktx) {
  const auto data = part(bytes, littleEndian(bytes, 56), littleEndian(bytes, 60), "the key/value data");
  if (!data) return tl::unexpected(data.error());
  for (size_t at = 0; at + 4 <= data->size();) {
    const size_t length = littleEndian(*data, at);
    at += 4;
    if (length > data->size() - at) return damaged("its key/value data is cut off");
    const std::string_view pair(reinterpret_cast<const char*>(data->data()) + at, length);
    const size_t end = std::min(pair.find('\0'), pair.size());
    const std::string_view key = pair.substr(0, end);
    std::string_view value = pair.substr(std::min(end + 1, pair.size()));
    value = value.substr(0, value.find('\0'));
    if (key == "KTXorientation") noteOrientation(value, ktx);
    if (key == "KTXswizzle") setSwizzle(value, ktx);
    at += std::min((length + 3) / 4 * 4, data->size() - at);
  }
  return {};
}

}  // namespace

bool isKtx2(Bytes bytes) {
  return bytes.size() >= sizeof identifier && std::memcmp(bytes.data(), identifier, sizeof identifier) == 0;
}

Result<Ktx2> readContainer(Bytes bytes) {
  Ktx2 ktx;
  if (bytes.size() < headerBytes) return damaged("it ends within its header");
  ktx.vkFormat = littleEndian(bytes, 12);
  const uint32_t scheme = littleEndian(bytes, 44);
  if (scheme > static_cast<uint32_t>(Supercompression::zlib))
    return fail("", "", "is a KTX2 texture with supercompression " + std::to_string(scheme) + ", which is not known",
                "save it with Zstandard or none");
  ktx.scheme = static_cast<Supercompression>(scheme);
  size_t levels = 0;
  if (auto ok = readSizes(bytes, ktx, levels); !ok) return tl::unexpected(ok.error());
  if (auto ok = readLevels(bytes, ktx, levels); !ok) return tl::unexpected(ok.error());
  if (auto ok = readDescriptor(bytes, ktx); !ok) return tl::unexpected(ok.error());
  if (auto ok = readKeyValues(bytes, ktx); !ok) return tl::unexpected(ok.error());
  const auto global = part(bytes, wideLittleEndian(bytes, 64), wideLittleEndian(bytes, 72), "its global data");
  if (!global) return tl::unexpected(global.error());
  ktx.globalData = *global;
  if (ktx.primaries > 1)  // KDFS 5.7: unspecified, Rec. 709
    ktx.remarks.push_back("its colours' primaries are not those of Rec. 709, and are shown as if they were");
  if (ktx.premultiplied)
    ktx.remarks.push_back("its colours are multiplied by alpha, and are shown as if they were not");
  return ktx;
}

}  // namespace facet::io
