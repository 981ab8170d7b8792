#pragma once

// What vertices and indices have to be. Each accessor is read once for each question, however many primitives share it.

#include "io/validate/asset.hpp"

namespace facet::io::validate {

void checkUnitVectors(Asset& asset, int accessor, bool tangents, const std::string& place);
void checkClamped(Asset& asset, int accessor, const std::string& place);
void checkIndexData(Asset& asset, int accessor, uint64_t vertices, bool triangles, const std::string& place);

// meshes.cpp
size_t targetCountOf(const Json& primitive);

}  // namespace facet::io::validate
