#pragma once

// The checks, one function for each section; in this order.

#include <span>
#include <string_view>

#include "io/validate/asset.hpp"

namespace facet::io::validate {

// container.cpp: the JSON of a .glb, or nothing; sets binary.
std::string_view checkContainer(Asset& asset, std::span<const uint8_t> bytes);
// text.cpp: fills asset.json; false where it is none.
bool readJson(Asset& asset, std::string_view text);
// root.cpp
void checkRoot(Asset& asset);         // version, names of extensions
void checkUnusedParts(Asset& asset);  // last
// buffers.cpp
void readBuffers(Asset& asset);
void readViews(Asset& asset);
void decodeCompressed(Asset& asset);  // by EXT or KHR_meshopt_compression
void useView(Asset& asset, int view, Use use, const std::string& place);
// accessors.cpp
void readAccessors(Asset& asset);
void checkAccessorData(Asset& asset);
// images.cpp: images, textures and what materials take of them
void checkImages(Asset& asset);
// materials.cpp
void checkMaterials(Asset& asset);
// cameras.cpp: and lights
void checkCameras(Asset& asset);
// meshes.cpp
void checkMeshes(Asset& asset);
// influences.cpp: joints and weights of skinned meshes
void checkInfluences(Asset& asset);
// nodes.cpp: and scenes
void checkNodes(Asset& asset);
// skins.cpp
void checkSkins(Asset& asset);
// animations.cpp
void checkAnimations(Asset& asset);
// surfaces.cpp: triangles, texel density, texture memory
void checkSurfaces(Asset& asset);

// shown.cpp: nodes and materials of all findings
void findShown(Asset& asset);

}  // namespace facet::io::validate
