#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace facet::test {

// What is wrong with the document by resources/schema/NAME.schema.json; empty: nothing.
std::string schemaProblems(const nlohmann::json& document, const std::string& name);

}  // namespace facet::test
