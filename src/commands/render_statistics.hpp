#pragma once

// What a picture took, as JSON (resources/schema/stats.schema.json).

#include <nlohmann/json.hpp>
#include <vector>

#include "base/sandbox.hpp"
#include "base/stages.hpp"
#include "commands/jobs.hpp"
#include "frame/session.hpp"

namespace facet::commands {

nlohmann::ordered_json statisticsJson(const Job& job, const frame::Session& session, const frame::Picture& picture,
                                      const Stages& stages, const Notes& notes, const Confined& confined);

// Of many pictures: wall milliseconds of each, from its model to its place in the film or its file.
nlohmann::ordered_json filmJson(double fps, const std::vector<double>& pictureMs);

}  // namespace facet::commands
