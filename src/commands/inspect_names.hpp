#pragma once

// What other commands can name of a file: scenes, cameras, animations, variants, materials.

#include <iosfwd>
#include <nlohmann/json_fwd.hpp>

#include "scene/model.hpp"

namespace facet::commands {

// By resources/schema/names.schema.json; members are added, none goes.
nlohmann::ordered_json describeNames(const scene::Model& model);

// A line each: kind, index, name, and what else there is to say, with tabs between.
void printNames(const nlohmann::ordered_json& described, std::ostream& out);

}  // namespace facet::commands
