#pragma once

#include <nlohmann/json_fwd.hpp>

#include "base/origin.hpp"

namespace facet {

// As every JSON of facet has it: all fields (resources/schema/origin.schema.json), null where there is nothing to say.
nlohmann::ordered_json originJson(const Origin& origin);

}  // namespace facet
