#pragma once

// KTX2 files made in a test.

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace facet::test {

struct Ktx2File {
  uint32_t vkFormat = 37, width = 1, height = 1, depth = 0, layers = 0, faces = 1;  // RGBA8
  uint32_t scheme = 0;
  uint8_t model = 1, primaries = 1, transfer = 1, flags = 0;
  std::vector<uint8_t> channelIds = {0, 1, 2, 15};
  std::vector<std::pair<std::string, std::string>> keyValues;
  std::vector<uint8_t> globalData;
  std::vector<std::vector<uint8_t>> levels;  // as stored
  std::vector<uint64_t> uncompressed;        // their lengths without supercompression; empty: as stored
  int levelCount = -1;                       // -1: as many as there are

  // The smallest level stands first, as the specification has it.
  std::vector<uint8_t> bytes() const;
};

std::vector<uint8_t> zstandard(const std::vector<uint8_t>& bytes);
std::vector<uint8_t> zlibDeflated(const std::vector<uint8_t>& bytes);

}  // namespace facet::test
