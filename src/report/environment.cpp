#include "report/environment.hpp"

#include "io/sources.hpp"

namespace facet::report {

Result<scene::Environment> environmentOf(const ReportInput& input) {
  Notes notes;
  Result<scene::Environment> environment = io::loadEnvironmentSource(input.environment, notes);
  for (const Note& note : notes)
    if (note.severity == Note::Severity::warning) input.warn(input.environment + ": " + note.text);
  return environment;
}

}  // namespace facet::report
