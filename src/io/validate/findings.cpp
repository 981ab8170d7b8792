#include "io/validate/findings.hpp"

#include <algorithm>

namespace facet::io::validate {

namespace {

struct Row {
  const char* name;
  Severity severity;
  const char* remedy;
};
constexpr Row rows[] = {
#define CODE(name, severity, remedy) {#name, Severity::severity, remedy},
#include "io/validate/codes.inc"
#undef CODE
};

}  // namespace

const char* name(Code code) { return rows[static_cast<size_t>(code)].name; }
Severity severity(Code code) { return rows[static_cast<size_t>(code)].severity; }
const char* remedy(Code code) { return rows[static_cast<size_t>(code)].remedy; }

size_t Report::count(Severity wanted) const {
  return static_cast<size_t>(
      std::ranges::count_if(findings, [&](const Finding& finding) { return severity(finding.code) == wanted; }));
}

}  // namespace facet::io::validate
