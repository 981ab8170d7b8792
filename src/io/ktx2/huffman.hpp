#pragma once

// Canonical Huffman codes as BasisLZ has them (KTX 2.0, appendix "BasisLZ/ETC1S Bitstream", "Compressed Huffman
// Tables"; RFC 1951, 3.2.2). Internal to io/.

#include <cstdint>
#include <vector>

#include "io/ktx2/bit_reader.hpp"

namespace facet::io {

struct HuffmanTable {
  struct Entry {
    uint16_t symbol = 0;
    uint8_t length = 0;  // 0: no code begins so
  };
  unsigned longest = 0;        // bits; 0: there are no symbols
  std::vector<Entry> entries;  // by the next `longest` bits

  // -1: no code of the table, or the end.
  int decode(BitReader& bits) const {
    if (longest == 0) return -1;
    const Entry entry = entries[bits.peek(longest)];
    bits.at += entry.length;
    return entry.length == 0 || bits.overran() ? -1 : entry.symbol;
  }
};

// Codes by their symbols' lengths, 0 to 16 bits. False: they are no prefix code, or leave codes without a symbol (but
// for one symbol alone).
bool makeHuffmanTable(const std::vector<uint8_t>& lengths, HuffmanTable& table);

// False: there is none at this place. A table without symbols is one.
bool readHuffmanTable(BitReader& bits, HuffmanTable& table);

}  // namespace facet::io
