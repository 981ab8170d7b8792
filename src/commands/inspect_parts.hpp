#pragma once

// What inspect tells of a model beside its geometry and shader variants.

#include <iosfwd>
#include <nlohmann/json.hpp>

#include "scene/model.hpp"

namespace facet::commands {

// By effect of an extension that can be seen, "clearcoat": its numbers that are not the default and the textures that
// it names. Null where there are none.
nlohmann::ordered_json describeEffects(const scene::Material& material);

// Adds "animations", "skins", "morphTargets", "instancing", "variants" and "xmp", each an array, to the object.
void describeParts(const scene::Model& model, nlohmann::ordered_json& out);

// The same as text; nothing of what is empty.
void printParts(const nlohmann::ordered_json& described, std::ostream& out);

}  // namespace facet::commands
