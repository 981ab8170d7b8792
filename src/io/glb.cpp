#include "io/glb.hpp"

#include <algorithm>
#include <string>

#include "io/little_endian.hpp"

namespace facet::io {

namespace {

constexpr uint64_t headerSize = 12, chunkHeaderSize = 8;
constexpr uint32_t jsonChunk = 0x4E4F534A, binaryChunk = 0x004E4942;  // "JSON", "BIN\0"

tl::unexpected<Error> error(uint64_t offset, std::string problem, std::string remedy = "export the model again") {
  return fail("", "byte " + std::to_string(offset), std::move(problem), std::move(remedy));
}

tl::unexpected<Error> truncated(uint64_t offset, uint64_t wanted, uint64_t size) {
  return error(
      offset,
      "the file is cut off: it should have " + std::to_string(wanted) + " bytes and has " + std::to_string(size),
      "copy or download it again");
}

// Whether a binary chunk that fits begins there.
bool binaryChunkAt(std::span<const uint8_t> bytes, uint64_t at, uint64_t length) {
  return at + chunkHeaderSize <= length && littleEndian(bytes, at + 4) == binaryChunk &&
         littleEndian(bytes, at) <= length - at - chunkHeaderSize;
}

}  // namespace

bool isGlb(std::span<const uint8_t> bytes) {
  constexpr std::string_view magic = "glTF";
  return bytes.size() >= magic.size() && std::equal(magic.begin(), magic.end(), bytes.begin());
}

Result<GlbParts> splitGlb(std::span<const uint8_t> bytes) {
  const uint64_t size = bytes.size();
  if (size < headerSize + chunkHeaderSize) return truncated(0, headerSize + chunkHeaderSize, size);
  const uint32_t version = littleEndian(bytes, 4);
  if (version != 2) {
    return error(4, "this is version " + std::to_string(version) + " of the binary container; only 2 is known",
                 "export the model as glTF 2.0");
  }
  const uint64_t length = littleEndian(bytes, 8);
  if (length > size) return truncated(8, length, size);
  if (length < headerSize + chunkHeaderSize) return error(8, "the length is " + std::to_string(length));

  GlbParts parts;
  bool first = true;
  for (uint64_t at = headerSize; at + chunkHeaderSize <= length;) {
    const uint64_t chunkSize = littleEndian(bytes, at);
    const uint32_t type = littleEndian(bytes, at + 4);
    if (chunkSize > length - at - chunkHeaderSize) {
      return error(at, "a chunk of " + std::to_string(chunkSize) + " bytes reaches beyond the file's length of " +
                           std::to_string(length));
    }
    const auto chunk = bytes.subspan(at + chunkHeaderSize, chunkSize);
    if (first && type != jsonChunk) return error(at + 4, "the first chunk is not JSON");
    if (first) parts.json = {reinterpret_cast<const char*>(chunk.data()), chunk.size()};
    if (type == binaryChunk && !parts.hasBinary) parts.binary = chunk, parts.hasBinary = true;
    first = false;
    const uint64_t end = at + chunkHeaderSize + chunkSize;
    at += chunkHeaderSize + (chunkSize + 3) / 4 * 4;
    if (at == end || binaryChunkAt(bytes, at, length) || !binaryChunkAt(bytes, end, length)) continue;
    parts.unpadded = true;  // as some writers do
    at = end;
  }
  // Padded with spaces by the book, with zeros by some writers.
  while (parts.json.ends_with('\0')) parts.json.remove_suffix(1);
  return parts;
}

}  // namespace facet::io
