#pragma once

// What a picture took, as JSON (resources/schema/stats.schema.json).

#include <nlohmann/json.hpp>

#include "base/sandbox.hpp"
#include "base/stages.hpp"
#include "commands/jobs.hpp"
#include "frame/session.hpp"

namespace facet::commands {

nlohmann::ordered_json statisticsJson(const Job& job, const frame::Session& session, const frame::Picture& picture,
                                      const Stages& stages, const Notes& notes, const Confined& confined);

}  // namespace facet::commands
