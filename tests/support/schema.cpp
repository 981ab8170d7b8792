#include "support/schema.hpp"

#include <fstream>
#include <nlohmann/json.hpp>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validation_results.hpp>
#include <valijson/validator.hpp>

namespace facet::test {

std::string schemaProblems(const nlohmann::json& document, const std::string& name) {
  std::ifstream file(FACET_SOURCE_DIR "/resources/schema/" + name + ".schema.json");
  if (!file) return "there is no schema " + name;
  const nlohmann::json text = nlohmann::json::parse(file);
  valijson::Schema schema;
  valijson::SchemaParser parser;
  parser.populateSchema(valijson::adapters::NlohmannJsonAdapter(text), schema);
  valijson::Validator validator;
  valijson::ValidationResults results;
  if (validator.validate(schema, valijson::adapters::NlohmannJsonAdapter(document), &results)) return {};
  std::string problems = "against its schema:";
  for (valijson::ValidationResults::Error error; results.popError(error);) {
    problems += "\n";
    for (const std::string& step : error.context) problems += step;
    problems += ": " + error.description;
  }
  return problems;
}

}  // namespace facet::test
