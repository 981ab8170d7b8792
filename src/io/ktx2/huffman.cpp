#include "io/ktx2/huffman.hpp"

#include <algorithm>

namespace facet::io {

namespace {

constexpr unsigned longestCode = 16;

uint32_t reversed(uint32_t code, unsigned bits) {
  uint32_t out = 0;
  for (unsigned i = 0; i < bits; ++i) out |= (code >> i & 1) << (bits - 1 - i);
  return out;
}

// The lengths of all symbols, themselves in codes with runs.
bool readLengths(BitReader& bits, const HuffmanTable& table, std::vector<uint8_t>& lengths) {
  constexpr int shortZeros = 17, longZeros = 18, shortRepeat = 19;
  size_t done = 0;
  const auto run = [&](size_t count, uint8_t length) {
    if (count > lengths.size() - done) return false;
    std::fill_n(lengths.begin() + static_cast<ptrdiff_t>(done), count, length);
    done += count;
    return true;
  };
  while (done < lengths.size()) {
    const int symbol = table.decode(bits);
    if (symbol < 0) return false;
    bool fits = true;
    if (symbol < shortZeros) {
      fits = run(1, static_cast<uint8_t>(symbol));
    } else if (symbol == shortZeros) {
      fits = run(3 + bits.take(3), 0);
    } else if (symbol == longZeros) {
      fits = run(11 + bits.take(7), 0);
    } else {
      if (done == 0 || lengths[done - 1] == 0) return false;
      fits = run(symbol == shortRepeat ? 3 + bits.take(2) : 7 + bits.take(7), lengths[done - 1]);
    }
    if (!fits) return false;
  }
  return !bits.overran();
}

}  // namespace

bool makeHuffmanTable(const std::vector<uint8_t>& lengths, HuffmanTable& table) {
  uint32_t counts[longestCode + 1] = {}, next[longestCode + 2] = {};
  uint32_t used = 0;
  table = {};
  for (const uint8_t length : lengths) {
    if (length > longestCode) return false;
    if (length == 0) continue;
    ++counts[length];
    ++used;
    table.longest = std::max<unsigned>(table.longest, length);
  }
  if (used == 0) return false;
  for (unsigned length = 1; length <= longestCode; ++length) {
    if (next[length] + counts[length] > 1u << length) return false;
    next[length + 1] = (next[length] + counts[length]) << 1;
  }
  if (next[longestCode + 1] != 1u << (longestCode + 1) && used != 1) return false;
  table.entries.resize(size_t{1} << table.longest);
  for (size_t symbol = 0; symbol < lengths.size(); ++symbol) {
    const unsigned length = lengths[symbol];
    if (length == 0) continue;
    const size_t first = reversed(next[length]++, length);
    for (size_t i = first; i < table.entries.size(); i += size_t{1} << length)
      table.entries[i] = {static_cast<uint16_t>(symbol), static_cast<uint8_t>(length)};
  }
  return true;
}

bool readHuffmanTable(BitReader& bits, HuffmanTable& table) {
  constexpr uint8_t order[] = {17, 18, 19, 20, 0, 8, 7, 9, 6, 10, 5, 11, 4, 12, 3, 13, 2, 14, 1, 15, 16};
  table = {};
  const uint32_t symbols = bits.take(14);
  if (symbols == 0) return !bits.overran();
  const uint32_t count = bits.take(5);
  if (count == 0 || count > std::size(order)) return false;
  std::vector<uint8_t> codeLengths(std::size(order));
  for (uint32_t i = 0; i < count; ++i) codeLengths[order[i]] = static_cast<uint8_t>(bits.take(3));
  HuffmanTable codes;
  if (!makeHuffmanTable(codeLengths, codes)) return false;
  std::vector<uint8_t> lengths(symbols);
  return readLengths(bits, codes, lengths) && makeHuffmanTable(lengths, table);
}

}  // namespace facet::io
