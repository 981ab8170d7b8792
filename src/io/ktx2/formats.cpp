#include "io/ktx2/formats.hpp"

#include "io/ktx2/blocks.hpp"

namespace facet::io {

namespace {

// Vulkan 1.3, section 49.1: VkFormat.
struct PlainRow {
  uint32_t unorm, srgb;  // 0: there is none
  int channels, bytesPerSample;
  bool bgr;
  const char* name;
};
constexpr PlainRow plainRows[] = {{9, 15, 1, 1, false, "R8"},     {16, 22, 2, 1, false, "RG8"},
                                  {23, 29, 3, 1, false, "RGB8"},  {30, 36, 3, 1, true, "BGR8"},
                                  {37, 43, 4, 1, false, "RGBA8"}, {44, 50, 4, 1, true, "BGRA8"},
                                  {70, 0, 1, 2, false, "R16"},    {77, 0, 2, 2, false, "RG16"},
                                  {84, 0, 3, 2, false, "RGB16"},  {91, 0, 4, 2, false, "RGBA16"}};

TexelFormat plainFormat(const PlainRow& row, bool srgb) {
  TexelFormat format;
  format.name = row.name;
  format.blockBytes = row.channels * row.bytesPerSample;
  format.channels = row.channels == 4 ? 4 : 3;  // what is not stored is 0, alpha 1
  format.bytesPerSample = row.bytesPerSample;
  format.storedChannels = row.channels;
  format.bgr = row.bgr;
  format.srgb = srgb;
  return format;
}

// Blocks of 4 x 4 texels.
struct BlockRow {
  uint32_t unorm, srgb;  // 0: there is none
  int bytes, channels;
  BlockDecoder decode;
  const char* name;
};
constexpr BlockRow blockRows[] = {{131, 132, 8, 3, decodeBc1, "BC1"},
                                  {133, 134, 8, 4, decodeBc1Alpha, "BC1 with alpha"},
                                  {135, 136, 16, 4, decodeBc2, "BC2"},
                                  {137, 138, 16, 4, decodeBc3, "BC3"},
                                  {139, 0, 8, 3, decodeBc4, "BC4"},
                                  {141, 0, 16, 3, decodeBc5, "BC5"},
                                  {145, 146, 16, 4, decodeBc7, "BC7"},
                                  {147, 148, 8, 3, decodeEtc2, "ETC2"},
                                  {149, 150, 8, 4, decodeEtc2Punch, "ETC2 with alpha of one bit"},
                                  {151, 152, 16, 4, decodeEtc2Alpha, "ETC2 with alpha"},
                                  {153, 0, 8, 3, decodeEacR11, "EAC R11"},
                                  {155, 0, 16, 3, decodeEacRg11, "EAC RG11"}};

TexelFormat blockFormat(const BlockRow& row, bool srgb) {
  TexelFormat format;
  format.name = row.name;
  format.blockWidth = format.blockHeight = 4;
  format.blockBytes = row.bytes;
  format.channels = row.channels;
  format.decodeBlock = row.decode;
  format.srgb = srgb;
  return format;
}

constexpr uint32_t firstAstc = 157, lastAstc = 184;  // UNORM and SRGB in turn, by the size of the blocks

TexelFormat astcFormat(uint32_t vkFormat) {
  constexpr uint8_t sizes[][2] = {{4, 4}, {5, 4},  {5, 5},  {6, 5},  {6, 6},   {8, 5},   {8, 6},
                                  {8, 8}, {10, 5}, {10, 6}, {10, 8}, {10, 10}, {12, 10}, {12, 12}};
  const auto& size = sizes[(vkFormat - firstAstc) / 2];
  TexelFormat format;
  format.blockWidth = size[0];
  format.blockHeight = size[1];
  format.name = "ASTC " + std::to_string(size[0]) + " x " + std::to_string(size[1]);
  format.blockBytes = 16;
  format.astc = true;
  format.srgb = (vkFormat - firstAstc) % 2 == 1;
  return format;
}

tl::unexpected<Error> notRead(const std::string& what) {
  return fail("", "", "is a KTX2 texture of " + what + ", which is not read", "convert it to UASTC, ETC1S or PNG");
}

// KTX 2.0, 3.11.3: what the channels of the two universal formats are, by the descriptor's samples.
Result<TexelFormat> etc1sFormat(const Ktx2& ktx) {
  constexpr uint8_t rgb = 0, rrr = 3, ggg = 4, aaa = 15;
  TexelFormat format;
  format.name = "ETC1S";
  format.blockWidth = format.blockHeight = 4;
  const std::vector<uint8_t>& ids = ktx.channelIds;
  format.channels = ids.size() == 2 ? 4 : 3;
  if (ids == std::vector<uint8_t>{rrr, ggg}) format.channelSwizzle = "ra01";
  const bool known = ids == std::vector<uint8_t>{rgb} || ids == std::vector<uint8_t>{rrr} ||
                     ids == std::vector<uint8_t>{rgb, aaa} || ids == std::vector<uint8_t>{rrr, ggg};
  if (!known) return notRead("ETC1S texels with unknown channels");
  return format;
}

Result<TexelFormat> uastcFormat(const Ktx2& ktx) {
  constexpr uint8_t rgb = 0, rgba = 3, rrr = 4, rrrg = 5, rg = 6;
  TexelFormat format;
  format.name = "UASTC";
  format.blockWidth = format.blockHeight = 4;
  format.blockBytes = 16;
  format.decodeBlock = decodeUastc;
  const uint8_t id = ktx.channelIds.empty() ? 255 : ktx.channelIds[0];
  format.channels = id == rgba || id == rrrg ? 4 : 3;
  if (id == rrrg) format.channelSwizzle = "ra01";
  if (id == rg) format.channelSwizzle = "rg01";
  if (id != rgb && id != rgba && id != rrr && id != rrrg && id != rg)
    return notRead("UASTC texels with unknown channels");
  return format;
}

}  // namespace

Result<TexelFormat> texelFormat(const Ktx2& ktx) {
  const bool basisLz = ktx.scheme == Supercompression::basisLz;
  if (basisLz != (ktx.model == ColorModel::etc1s))
    return notRead(basisLz ? "BasisLZ without ETC1S" : "ETC1S without BasisLZ");
  if (basisLz) return etc1sFormat(ktx);
  if (ktx.model == ColorModel::uastc && ktx.vkFormat == 0) return uastcFormat(ktx);
  for (const PlainRow& row : plainRows) {
    if (ktx.vkFormat != row.unorm && (ktx.vkFormat != row.srgb || row.srgb == 0)) continue;
    return plainFormat(row, ktx.vkFormat == row.srgb);
  }
  for (const BlockRow& row : blockRows) {
    if (ktx.vkFormat != row.unorm && (ktx.vkFormat != row.srgb || row.srgb == 0)) continue;
    return blockFormat(row, ktx.vkFormat == row.srgb);
  }
  if (ktx.vkFormat >= firstAstc && ktx.vkFormat <= lastAstc) return astcFormat(ktx.vkFormat);
  return notRead("VkFormat " + std::to_string(ktx.vkFormat));
}

uint64_t levelBytes(const TexelFormat& format, int width, int height) {
  const auto blocks = [](int texels, int size) { return static_cast<uint64_t>((texels - 1) / size + 1); };
  return blocks(width, format.blockWidth) * blocks(height, format.blockHeight) *
         static_cast<uint64_t>(format.blockBytes);
}

}  // namespace facet::io
