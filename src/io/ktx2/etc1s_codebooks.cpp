#include "io/image_formats.hpp"
#include "io/ktx2/etc1s.hpp"
#include "io/little_endian.hpp"

namespace facet::io {

namespace {

using Bytes = std::span<const uint8_t>;

// "ETC1S Endpoint Codebooks": differences to the entry before.
bool readEndpoints(Bytes bytes, std::vector<Etc1sEndpoint>& endpoints) {
  BitReader bits{bytes};
  HuffmanTable colors[3], intensities;
  for (HuffmanTable& table : colors)
    if (!readHuffmanTable(bits, table)) return false;
  if (!readHuffmanTable(bits, intensities)) return false;
  const bool grey = bits.take(1) != 0;
  Etc1sEndpoint last{{16, 16, 16}, 0};
  for (Etc1sEndpoint& endpoint : endpoints) {
    const int intensity = intensities.decode(bits);
    if (intensity < 0) return false;
    last.intensity = static_cast<uint8_t>((last.intensity + intensity) & 7);
    for (size_t c = 0; c < (grey ? 1 : 3); ++c) {
      const uint8_t before = last.color[c];
      const int delta = colors[before <= 9 ? 0 : before <= 21 ? 1 : 2].decode(bits);
      if (delta < 0) return false;
      last.color[c] = static_cast<uint8_t>((before + delta) & 31);
    }
    if (grey) last.color[1] = last.color[2] = last.color[0];
    endpoint = last;
  }
  return true;
}

// "ETC1S Selector Codebooks": differences (XOR) to the entry before, or raw.
bool readSelectors(Bytes bytes, std::vector<Etc1sSelector>& selectors) {
  BitReader bits{bytes};
  if (bits.take(2) != 0) return false;
  const bool raw = bits.take(1) != 0;
  HuffmanTable deltas;
  if (!raw && !readHuffmanTable(bits, deltas)) return false;
  Etc1sSelector last = {};
  for (size_t i = 0; i < selectors.size(); ++i) {
    for (uint8_t& row : last) {
      const int value = raw || i == 0 ? static_cast<int>(bits.take(8)) : deltas.decode(bits);
      if (value < 0 || value > 255 || bits.overran()) return false;
      row = static_cast<uint8_t>(raw || i == 0 ? value : row ^ value);
    }
    selectors[i] = last;
  }
  return true;
}

// "ETC1S Slice Huffman Tables"
bool readSliceTables(Bytes bytes, Etc1s& etc1s) {
  BitReader bits{bytes};
  for (HuffmanTable* table : {&etc1s.predictions, &etc1s.endpointDeltas, &etc1s.selectorSymbols, &etc1s.runs})
    if (!readHuffmanTable(bits, *table)) return false;
  etc1s.historySize = bits.take(13);
  return !bits.overran();
}

bool inside(uint32_t offset, uint32_t length, size_t size) { return offset <= size && length <= size - offset; }

// The image descriptions: where each level's slices lie.
Result<void> readLevels(Bytes global, const Ktx2& ktx, Etc1s& etc1s) {
  constexpr size_t headerBytes = 20, imageBytes = 20;
  constexpr uint32_t predictedFrame = 2;
  const bool two = ktx.channelIds.size() > 1;
  for (size_t i = 0; i < ktx.levels.size(); ++i) {
    const size_t at = headerBytes + i * imageBytes, size = ktx.levels[i].bytes.size();
    if (littleEndian(global, at) & predictedFrame)
      return fail("", "", "is a frame of a KTX2 video, and only plain 2D textures are shown", "save a 2D texture");
    const Etc1sLevel level{littleEndian(global, at + 4), littleEndian(global, at + 8), littleEndian(global, at + 12),
                           littleEndian(global, at + 16)};
    if (level.colorLength == 0 || (two && level.alphaLength == 0) ||
        !inside(level.colorOffset, level.colorLength, size) || !inside(level.alphaOffset, level.alphaLength, size))
      return damagedImage("a slice of its level " + std::to_string(i) + " lies outside the level");
    etc1s.levels.push_back(level);
  }
  return {};
}

}  // namespace

Result<Etc1s> readEtc1s(const Ktx2& ktx) {
  const Bytes global = ktx.globalData;
  const size_t head = 20 + 20 * ktx.levels.size();
  if (global.size() < head) return damagedImage("its BasisLZ global data is too short");
  Etc1s etc1s;
  const uint32_t endpoints = littleEndian(global, 0) & 0xFFFF, selectors = littleEndian(global, 0) >> 16;
  const uint64_t lengths[] = {littleEndian(global, 4), littleEndian(global, 8), littleEndian(global, 12)};
  if (lengths[0] + lengths[1] + lengths[2] > global.size() - head)
    return damagedImage("its BasisLZ codebooks lie outside the global data");
  if (endpoints == 0 || selectors == 0) return damagedImage("its BasisLZ codebooks are empty");
  if (auto ok = readLevels(global, ktx, etc1s); !ok) return tl::unexpected(ok.error());
  Bytes rest = global.subspan(head);
  const auto next = [&](uint64_t length) {
    const Bytes part = rest.first(static_cast<size_t>(length));
    rest = rest.subspan(static_cast<size_t>(length));
    return part;
  };
  etc1s.endpoints.resize(endpoints);
  etc1s.selectors.resize(selectors);
  if (!readEndpoints(next(lengths[0]), etc1s.endpoints)) return damagedImage("its BasisLZ endpoints are faulty");
  if (!readSelectors(next(lengths[1]), etc1s.selectors)) return damagedImage("its BasisLZ selectors are faulty");
  if (!readSliceTables(next(lengths[2]), etc1s)) return damagedImage("its BasisLZ tables are faulty");
  return etc1s;
}

}  // namespace facet::io
