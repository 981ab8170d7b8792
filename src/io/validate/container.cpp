// The binary container (glTF 2.0, section 4), chunk after chunk; goes on where splitGlb gives up.

#include <charconv>

#include "io/little_endian.hpp"
#include "io/validate/checks.hpp"

namespace facet::io::validate {

namespace {

constexpr uint64_t headerSize = 12, chunkHeaderSize = 8;
constexpr uint32_t jsonChunk = 0x4E4F534A, binaryChunk = 0x004E4942;  // "JSON", "BIN\0"

std::string byteText(uint64_t offset) { return "byte " + std::to_string(offset); }

std::string typeText(uint32_t type) {
  char text[16] = "0x";
  return {text, std::to_chars(text + 2, text + sizeof text, type, 16).ptr};
}

struct Chunks {
  size_t count = 0;
  bool hasJson = false;
  std::string_view json;
};

void checkChunk(Asset& asset, Chunks& chunks, uint32_t type, uint64_t at, std::span<const uint8_t> data) {
  if (chunks.count == 0 && type != jsonChunk)
    asset.add(Code::GLB_UNEXPECTED_FIRST_CHUNK, byteText(at), "the first chunk is " + typeText(type) + ", not JSON");
  if (type == jsonChunk) {
    if (data.empty()) asset.add(Code::GLB_EMPTY_CHUNK, byteText(at), "the JSON chunk is empty");
    if (chunks.hasJson) asset.add(Code::GLB_DUPLICATE_CHUNK, byteText(at), "is a second JSON chunk");
    if (!chunks.hasJson) chunks.json = {reinterpret_cast<const char*>(data.data()), data.size()};
    chunks.hasJson = true;
  } else if (type == binaryChunk) {
    if (data.empty()) asset.add(Code::GLB_EMPTY_BIN_CHUNK, byteText(at), "the binary chunk is empty");
    if (asset.hasBinary)
      asset.add(Code::GLB_DUPLICATE_CHUNK, byteText(at), "is a second binary chunk");
    else if (chunks.count > 1)
      asset.add(Code::GLB_UNEXPECTED_BIN_CHUNK, byteText(at), "the binary chunk is not the second one");
    if (!asset.hasBinary) asset.binary = data;
    asset.hasBinary = true;
  } else {
    asset.add(Code::GLB_UNKNOWN_CHUNK_TYPE, byteText(at), "the chunk's type is " + typeText(type));
  }
  ++chunks.count;
}

}  // namespace

std::string_view checkContainer(Asset& asset, std::span<const uint8_t> bytes) {
  asset.isGlb = true;
  if (bytes.size() < headerSize) {
    asset.add(Code::GLB_UNEXPECTED_END_OF_HEADER, byteText(bytes.size()), "the file ends in its header");
    return {};
  }
  if (const uint32_t version = littleEndian(bytes, 4); version != 2) {
    asset.add(Code::GLB_INVALID_VERSION, byteText(4),
              "the container's version is " + std::to_string(version) + ", not 2");
    return {};
  }
  const uint64_t length = littleEndian(bytes, 8);
  if (length <= headerSize)
    asset.add(Code::GLB_LENGTH_TOO_SMALL, byteText(8), "the length is " + std::to_string(length));
  Chunks chunks;
  uint64_t at = headerSize;
  while (at < bytes.size() && at != length) {
    if (bytes.size() - at < chunkHeaderSize) {
      asset.add(Code::GLB_UNEXPECTED_END_OF_CHUNK_HEADER, byteText(bytes.size()), "the file ends in a chunk's header");
      return chunks.json;
    }
    const uint64_t size = littleEndian(bytes, at);
    const uint32_t type = littleEndian(bytes, at + 4);
    if (size % 4 != 0)
      asset.add(Code::GLB_CHUNK_LENGTH_UNALIGNED, byteText(at),
                "the chunk's length of " + std::to_string(size) + " is no multiple of 4");
    if (at + chunkHeaderSize + size > length)
      asset.add(Code::GLB_CHUNK_TOO_BIG, byteText(at),
                "a chunk of " + std::to_string(size) + " bytes ends beyond the length of " + std::to_string(length));
    const uint64_t have = std::min(size, bytes.size() - at - chunkHeaderSize);
    checkChunk(asset, chunks, type, at, bytes.subspan(at + chunkHeaderSize, have));
    if (have < size) {
      asset.add(Code::GLB_UNEXPECTED_END_OF_CHUNK_DATA, byteText(bytes.size()), "the file ends in a chunk");
      return chunks.json;
    }
    at += chunkHeaderSize + size;
  }
  if (at < bytes.size())
    asset.add(Code::GLB_EXTRA_DATA, byteText(at), std::to_string(bytes.size() - at) + " bytes follow the file's end");
  else if (at != length)
    asset.add(Code::GLB_LENGTH_MISMATCH, byteText(8),
              "the length is " + std::to_string(length) + ", but there are " + std::to_string(bytes.size()) + " bytes");
  return chunks.json;
}

}  // namespace facet::io::validate
