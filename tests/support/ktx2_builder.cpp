#include "support/ktx2_builder.hpp"

#include <zlib.h>
#include <zstd.h>

namespace facet::test {

namespace {

using Bytes = std::vector<uint8_t>;

void append(Bytes& to, uint64_t value, int size) {
  for (int i = 0; i < size; ++i) to.push_back(static_cast<uint8_t>(value >> 8 * i));
}
void append(Bytes& to, const Bytes& from) { to.insert(to.end(), from.begin(), from.end()); }
void pad(Bytes& to, size_t multiple) { to.resize((to.size() + multiple - 1) / multiple * multiple); }

Bytes descriptor(const Ktx2File& file) {
  const size_t block = 24 + 16 * file.channelIds.size();
  Bytes out;
  append(out, 4 + block, 4);
  append(out, 0, 4);
  append(out, 2 | block << 16, 4);
  append(out, {file.model, file.primaries, file.transfer, file.flags});
  append(out, 0, 8);
  append(out, 0, 4);
  for (const uint8_t id : file.channelIds) {
    append(out, {0, 0, 7, id});
    append(out, 0, 4);
    append(out, 0, 4);
    append(out, 255, 4);
  }
  return out;
}

Bytes keyValueData(const Ktx2File& file) {
  Bytes out;
  for (const auto& [key, value] : file.keyValues) {
    append(out, key.size() + value.size() + 2, 4);
    out.insert(out.end(), key.begin(), key.end());
    out.push_back(0);
    out.insert(out.end(), value.begin(), value.end());
    out.push_back(0);
    pad(out, 4);
  }
  return out;
}

}  // namespace

Bytes Ktx2File::bytes() const {
  const Bytes dfd = descriptor(*this), kvd = keyValueData(*this);
  const size_t count = levels.size(), dfdAt = 80 + 24 * count, kvdAt = dfdAt + dfd.size();
  const size_t globalAt = (kvdAt + kvd.size() + 7) / 8 * 8;
  Bytes data;
  std::vector<size_t> offsets(count);
  for (size_t i = count; i-- > 0;) {
    pad(data, 16);
    offsets[i] = (globalAt + globalData.size() + 15) / 16 * 16 + data.size();
    append(data, levels[i]);
  }
  Bytes out = {0xAB, 'K', 'T', 'X', ' ', '2', '0', 0xBB, '\r', '\n', 0x1A, '\n'};
  for (const uint32_t value :
       {vkFormat, 1u, width, height, depth, layers, faces,
        levelCount < 0 ? static_cast<uint32_t>(count) : static_cast<uint32_t>(levelCount), scheme})
    append(out, value, 4);
  for (const size_t value : {dfdAt, dfd.size(), kvd.empty() ? 0 : kvdAt, kvd.size()}) append(out, value, 4);
  append(out, globalData.empty() ? 0 : globalAt, 8);
  append(out, globalData.size(), 8);
  for (size_t i = 0; i < count; ++i) {
    append(out, offsets[i], 8);
    append(out, levels[i].size(), 8);
    append(out, uncompressed.empty() ? levels[i].size() : uncompressed[i], 8);
  }
  append(out, dfd);
  append(out, kvd);
  pad(out, 8);
  append(out, globalData);
  pad(out, 16);
  append(out, data);
  return out;
}

Bytes zstandard(const Bytes& bytes) {
  Bytes out(ZSTD_compressBound(bytes.size()));
  out.resize(ZSTD_compress(out.data(), out.size(), bytes.data(), bytes.size(), 3));
  return out;
}

Bytes zlibDeflated(const Bytes& bytes) {
  uLongf size = compressBound(static_cast<uLong>(bytes.size()));
  Bytes out(size);
  compress(out.data(), &size, bytes.data(), static_cast<uLong>(bytes.size()));
  out.resize(size);
  return out;
}

}  // namespace facet::test
