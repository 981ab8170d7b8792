#pragma once

// What inspect tells of a model beside its geometry and shader variants.

#include <iosfwd>
#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "optics/measured.hpp"
#include "scene/model.hpp"

namespace facet::commands {

// By effect of an extension that can be seen, "clearcoat": its numbers that are not the default and the textures that
// it names. Null where there are none.
nlohmann::ordered_json describeEffects(const scene::Material& material);

// A measured BRDF in the place of the materials: what it is, where it was found, what it takes on the GPU.
nlohmann::ordered_json describeMeasured(const optics::MeasuredBrdf& brdf, const std::string& source);

// Adds "animations", "skins", "morphTargets", "instancing", "variants" and "xmp", each an array, to the object.
void describeParts(const scene::Model& model, nlohmann::ordered_json& out);

// An array: each image's name, format, size, depth and mip levels as its header says, or its "problem", and whether it
// is "decoded".
nlohmann::ordered_json describeImages(const scene::Model& model, const std::vector<bool>& decoded);

void printMeasured(const nlohmann::ordered_json& described, std::ostream& out);
// The parts as text; nothing of what is empty.
void printParts(const nlohmann::ordered_json& described, std::ostream& out);
// The images as text; nothing where there are none.
void printImages(const nlohmann::ordered_json& images, std::ostream& out);

}  // namespace facet::commands
