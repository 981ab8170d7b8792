#pragma once

// What inspect tells of a model beside its geometry and shader variants.

#include <iosfwd>
#include <nlohmann/json_fwd.hpp>

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

void printMeasured(const nlohmann::ordered_json& described, std::ostream& out);
// The parts as text; nothing of what is empty.
void printParts(const nlohmann::ordered_json& described, std::ostream& out);

}  // namespace facet::commands
