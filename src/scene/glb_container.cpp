#include "scene/glb_container.hpp"

namespace facet::scene {

namespace {

void addContainerWord(std::vector<uint8_t>& out, size_t word) {
  for (int shift = 0; shift < 32; shift += 8) out.push_back(static_cast<uint8_t>(word >> shift));
}

}  // namespace

std::vector<uint8_t> glbContainer(std::string json, std::span<const uint8_t> binary) {
  json.resize((json.size() + 3) / 4 * 4, ' ');
  const size_t padded = (binary.size() + 3) / 4 * 4;
  std::vector<uint8_t> out;
  out.reserve(28 + json.size() + padded);
  addContainerWord(out, 0x46546C67);  // "glTF"
  addContainerWord(out, 2);
  addContainerWord(out, 12 + 8 + json.size() + (binary.empty() ? 0 : 8 + padded));
  addContainerWord(out, json.size());
  addContainerWord(out, 0x4E4F534A);  // "JSON"
  out.insert(out.end(), json.begin(), json.end());
  if (binary.empty()) return out;
  addContainerWord(out, padded);
  addContainerWord(out, 0x004E4942);  // "BIN"
  out.insert(out.end(), binary.begin(), binary.end());
  out.resize(out.size() + padded - binary.size());
  return out;
}

}  // namespace facet::scene
