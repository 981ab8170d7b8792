#include "io/ktx2/huffman.hpp"

#include <catch2/catch.hpp>

using namespace facet;
using Lengths = std::vector<uint8_t>;

namespace {

// What the table reads from the bits, each from the lowest of the first byte on.
std::vector<int> symbols(const io::HuffmanTable& table, const std::vector<uint8_t>& bytes, size_t count) {
  io::BitReader bits{bytes};
  std::vector<int> out;
  for (size_t i = 0; i < count; ++i) out.push_back(table.decode(bits));
  return out;
}

}  // namespace

TEST_CASE("Canonical Huffman codes of RFC 1951's example", "[io][ktx2]") {
  // 3.2.2: symbols A to H with 3, 3, 3, 3, 3, 2, 4 and 4 bits; F is 00, A 010, G 1110, H 1111.
  io::HuffmanTable table;
  REQUIRE(io::makeHuffmanTable(Lengths{3, 3, 3, 3, 3, 2, 4, 4}, table));
  CHECK(table.longest == 4);
  // F A G H F: 00 010 1110 1111 00, the first bit lowest
  CHECK(symbols(table, {0b11101000, 0b00011110}, 6) == std::vector<int>{5, 0, 6, 7, 5, -1});
}

TEST_CASE("Lengths that make no prefix code are refused", "[io][ktx2]") {
  io::HuffmanTable table;
  CHECK_FALSE(io::makeHuffmanTable(Lengths{1, 1, 1}, table));  // too many
  CHECK_FALSE(io::makeHuffmanTable(Lengths{1, 2, 2, 9}, table));
  CHECK_FALSE(io::makeHuffmanTable(Lengths{1, 2}, table));    // codes that are left over
  CHECK_FALSE(io::makeHuffmanTable(Lengths{17, 17}, table));  // too long
  CHECK_FALSE(io::makeHuffmanTable(Lengths{0, 0}, table));    // none
  CHECK(io::makeHuffmanTable(Lengths{0, 1, 2, 2}, table));
  Lengths longest(17, 16);
  for (uint8_t i = 1; i < 16; ++i) longest[i] = i;
  longest.resize(17);
  longest[0] = longest[16] = 16;
  CHECK(io::makeHuffmanTable(longest, table));
  // One symbol alone has a code all the same; the other one is none.
  REQUIRE(io::makeHuffmanTable(Lengths{0, 0, 1}, table));
  CHECK(symbols(table, {0b00000010}, 3) == std::vector<int>{2, -1, -1});
}

TEST_CASE("Bits past the end are 0, and known as such", "[io][ktx2]") {
  const std::vector<uint8_t> bytes = {0xFF, 0x01};
  io::BitReader bits{bytes};
  CHECK(bits.take(4) == 15);
  CHECK(bits.peek(12) == 0x01F);
  CHECK(bits.take(12) == 0x01F);
  CHECK_FALSE(bits.overran());
  CHECK(bits.take(25) == 0);
  CHECK(bits.overran());
}
