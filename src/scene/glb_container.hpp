#pragma once

// The container of binary glTF (GLB, version 2), written.

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace facet::scene {

// The JSON text and, where there are any, the bytes of its first buffer, each filled up to whole words. All of it is
// less than 4 GiB.
std::vector<uint8_t> glbContainer(std::string json, std::span<const uint8_t> binary);

}  // namespace facet::scene
