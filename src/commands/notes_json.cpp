#include "commands/notes_json.hpp"

#include <nlohmann/json.hpp>

namespace facet::commands {

nlohmann::ordered_json notesJson(const Notes& notes) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const Note& note : notes)
    list.push_back({{"severity", note.severity == Note::Severity::warning ? "warning" : "info"},
                    {"place", note.place},
                    {"text", note.text}});
  return list;
}

}  // namespace facet::commands
