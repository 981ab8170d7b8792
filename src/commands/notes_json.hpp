#pragma once

#include <nlohmann/json.hpp>

#include "base/error.hpp"

namespace facet::commands {

// Notes as every command's machine-readable output has them.
inline nlohmann::ordered_json notesJson(const Notes& notes) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const Note& note : notes)
    list.push_back({{"severity", note.severity == Note::Severity::warning ? "warning" : "info"},
                    {"place", note.place},
                    {"text", note.text}});
  return list;
}

}  // namespace facet::commands
