#include "commands/inspect_findings.hpp"

#include <array>
#include <map>
#include <nlohmann/json.hpp>
#include <ostream>

namespace facet::commands {

namespace {

using io::validate::Finding;
using io::validate::Severity;

constexpr size_t fewOfACode = 5;
constexpr std::array severities = {Severity::error, Severity::warning, Severity::info, Severity::hint};

const char* word(Severity severity) { return io::validate::severityNames[size_t(severity)]; }

// "2 errors, 1 warning"
std::string counted(const io::validate::Report& report) {
  std::string out;
  for (const Severity severity : severities) {
    const size_t count = report.count(severity);
    if (count == 0) continue;
    out += (out.empty() ? "" : ", ") + std::to_string(count) + " " + word(severity) + (count > 1 ? "s" : "");
  }
  return out;
}

}  // namespace

nlohmann::ordered_json describeValidation(const io::validate::Report& report) {
  nlohmann::ordered_json out, findings = nlohmann::ordered_json::array(), densities = nlohmann::ordered_json::array();
  for (const Severity severity : severities) out[word(severity) + std::string("s")] = report.count(severity);
  out["leftOut"] = report.leftOut;
  for (const Finding& finding : report.findings) {
    findings.push_back({{"severity", word(severity(finding.code))},
                        {"code", name(finding.code)},
                        {"pointer", finding.place},
                        {"message", finding.text},
                        {"remedy", remedy(finding.code)}});
    if (finding.node >= 0) findings.back()["node"] = finding.node;
    if (finding.material >= 0) findings.back()["material"] = finding.material;
  }
  for (const io::validate::TexelDensity& d : report.densities)
    densities.push_back(
        {{"pointer", d.place}, {"texture", d.texture}, {"low", d.low}, {"median", d.middle}, {"high", d.high}});
  out["findings"] = findings;
  out["texelDensity"] = densities;
  out["textureBytes"] = report.textureBytes;
  return out;
}

void printValidation(const io::validate::Report& report, bool all, std::ostream& out) {
  out << "\nWhat is wrong with the file\n";
  const std::string counts = counted(report);
  out << "  " << (counts.empty() ? "nothing" : counts) << "\n";
  std::map<io::validate::Code, size_t> seen, hidden;
  for (const Finding& finding : report.findings) {
    if (!all && ++seen[finding.code] > fewOfACode) {
      ++hidden[finding.code];
      continue;
    }
    out << "  " << word(severity(finding.code)) << " " << name(finding.code) << ": " << finding.place
        << (finding.place.empty() ? "" : ": ") << finding.text << "; " << remedy(finding.code) << "\n";
  }
  for (const auto& [code, count] : hidden)
    out << "  and " << count << " more of " << name(code) << ": --all lists them\n";
  if (report.leftOut > 0) out << "  and " << report.leftOut << " more that are not kept\n";
}

}  // namespace facet::commands
