#pragma once

// Loading what GltfBuilder made, and saying in text what came of it.

#include <string>

#include "io/gltf.hpp"
#include "support/gltf_builder.hpp"

namespace facet::test {

// The message, or "loaded".
std::string outcome(const Result<io::LoadedModel>& result);
std::string outcome(const std::string& gltfText);

// Fails the test case with the message where the file is refused.
io::LoadedModel loaded(const GltfBuilder& builder);

// The notes as "place: text", one a line; warnings begin with "! ".
std::string notes(const io::LoadedModel& model);

// The first one of mesh 0.
const scene::Primitive& primitive(const io::LoadedModel& model);

// Attributes of mesh 0's first primitive.
nlohmann::json& attributes(GltfBuilder& builder);

}  // namespace facet::test
