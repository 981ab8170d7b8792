#include "base/origin_json.hpp"

#include <nlohmann/json.hpp>

namespace facet {

nlohmann::ordered_json originJson(const Origin& origin) {
  nlohmann::ordered_json out = nlohmann::ordered_json::object();
  for (const auto& [name, value] : originFields(origin))
    out[name] = value.empty() ? nlohmann::ordered_json() : nlohmann::ordered_json(value);
  if (origin.seed) out["seed"] = *origin.seed;
  return out;
}

}  // namespace facet
