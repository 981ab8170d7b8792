#include <algorithm>
#include <cstdio>

#include "compare/regression.hpp"

namespace facet::compare {

namespace {

// For text and quoted attributes of HTML and XML. What XML 1.0 has no way to say becomes a question mark.
std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '&')
      out += "&amp;";
    else if (c == '<')
      out += "&lt;";
    else if (c == '>')
      out += "&gt;";
    else if (c == '"')
      out += "&quot;";
    else if (static_cast<unsigned char>(c) < 32 && c != '\n' && c != '\t')
      out += '?';
    else
      out += c;
  }
  return out;
}

std::string figure(double value, const char* format = "%.4g") {
  char text[40];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

constexpr const char* head = R"(<!doctype html>
<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width, initial-scale=1">
<style>
:root { color-scheme: light dark; --line: #8886; --bad: #c33; --good: #2a7d4f; --quiet: #888; }
body { font: 14px/1.45 system-ui, sans-serif; margin: 24px auto; max-width: 1200px; padding: 0 16px; }
h1 { font-size: 20px; margin: 0 0 4px; } h2 { font-size: 15px; margin: 0; }
.quiet { color: var(--quiet); } .bad { color: var(--bad); } .good { color: var(--good); }
article { border-top: 1px solid var(--line); padding: 14px 0; }
.pictures { display: flex; flex-wrap: wrap; gap: 12px; margin: 8px 0; }
figure { margin: 0; } figcaption { color: var(--quiet); font-size: 12px; }
figure img, .blink { width: 256px; height: auto; display: block;
  background: repeating-conic-gradient(#ccc 0 25%, #eee 0 50%) 0 0 / 16px 16px; image-rendering: pixelated; }
.blink { position: relative; } .blink img { width: 100%; }
.blink img + img { position: absolute; inset: 0; animation: blink 1s steps(1) infinite; }
@keyframes blink { 50% { opacity: 0; } }
.legend { width: 160px; } .ticks { display: flex; justify-content: space-between; font-size: 11px; }
.scale { height: 12px; background: linear-gradient(to right, #000, #00f, #f00, #ff0, #fff); border: 1px solid var(--line); }
table { border-collapse: collapse; font-variant-numeric: tabular-nums; }
td { padding: 0 14px 0 0; } code { font-size: 12px; overflow-wrap: anywhere; }
details > summary { cursor: pointer; padding: 12px 0; border-top: 1px solid var(--line); }
details article { border-top: none; padding: 8px 0; }
</style>
)";

std::string image(const std::string& file, const std::string& alt) {
  return "<img loading=\"lazy\" src=\"" + escaped(file) + "\" alt=\"" + escaped(alt) + "\">";
}

// Of the colours of a difference (heatColor), whose scale is that of the square root.
std::string legend(bool flip) {
  std::string out = "<figure class=\"legend\"><div class=\"scale\"></div><div class=\"ticks\">";
  for (const char* tick : {"0", "0.06", "0.25", "0.56", "1"}) out += std::string("<span>") + tick + "</span>";
  return out + "</div><figcaption>" +
         (flip
              ? "the difference is FLIP: what one sees when both pictures alternate; 0.1 is just noticeable"
              : "the difference is the largest of any channel on the screen, over black and over white, and of alpha") +
         "; magenta: not finite</figcaption></figure>";
}

std::string pictures(const JobResult& job) {
  std::string out = "<div class=\"pictures\">";
  const auto add = [&](const std::string& file, const char* caption) {
    if (file.empty()) return;
    out += "<figure>" + image(file, job.name + ", " + caption) + "<figcaption>" + caption + "</figcaption></figure>";
  };
  add(job.baseline, "before");
  add(job.picture, "after");
  add(job.difference, "difference");
  if (!job.difference.empty()) out += legend(job.differenceOf == "flip");
  if (!job.baseline.empty() && !job.picture.empty() && !job.difference.empty())
    out += "<figure><div class=\"blink\">" + image(job.baseline, "before") + image(job.picture, "after") +
           "</div><figcaption>before and after in turns</figcaption></figure>";
  return out + "</div>";
}

std::string figuresTable(const JobResult& job) {
  if (job.figures.empty()) return {};
  std::string out = "<table><tr>";
  for (const auto& [name, value] : job.figures) out += "<td class=\"quiet\">" + escaped(name) + "</td>";
  out += "</tr><tr>";
  for (const auto& [name, value] : job.figures) {
    const auto limit = std::ranges::find(job.limits, name, &std::pair<std::string, double>::first);
    const bool beyond = limit != job.limits.end() && value > limit->second;
    out += std::string("<td") + (beyond ? " class=\"bad\"" : "") + ">" + figure(value);
    if (limit != job.limits.end()) out += " <span class=\"quiet\">of " + figure(limit->second) + "</span>";
    out += "</td>";
  }
  return out + "</tr></table>";
}

std::string article(const JobResult& job) {
  const char* mood = job.good() ? "good" : "bad";
  std::string out = "<article id=\"" + escaped(job.name) + "\"><h2>" + escaped(job.name) + " <span class=\"" + mood +
                    "\">" + std::string(nameOf(job.status)) + "</span></h2>";
  if (!job.message.empty()) out += std::string("<div class=\"") + mood + "\">" + escaped(job.message) + "</div>";
  if (job.otherRenderer()) out += "<div class=\"quiet\">before: " + escaped(job.baselineRenderer) + "</div>";
  for (const std::string& warning : job.warnings) out += "<div class=\"quiet\">" + escaped(warning) + "</div>";
  out += pictures(job) + figuresTable(job);
  return out + "<div><code>" + escaped(job.command) + "</code> <span class=\"quiet\">" +
         figure(job.milliseconds, "%.0f") + " ms</span></div></article>\n";
}

std::string totals(const RegressionReport& report) {
  std::string text;
  for (const JobStatus status :
       {JobStatus::failed, JobStatus::differs, JobStatus::missing, JobStatus::accepted, JobStatus::passed}) {
    const auto count = std::ranges::count(report.jobs, status, &JobResult::status);
    if (count > 0) text += (text.empty() ? "" : ", ") + std::to_string(count) + " " + std::string(nameOf(status));
  }
  return text.empty() ? "no jobs" : text;
}

}  // namespace

std::string reportHtml(const RegressionReport& report) {
  const char* mood = report.good() ? "good" : "bad";
  std::string page = head + ("<title>" + escaped(report.suite) + ": " + totals(report) + "</title></head><body>\n");
  page += "<h1>" + escaped(report.suite) + " <span class=\"" + mood + "\">" + totals(report) + "</span></h1>";
  page += "<p class=\"quiet\">" + escaped(report.renderer);
  for (const auto& [name, value] : originFields(report.origin))
    if (!value.empty() && name != "renderer") page += ", " + name + " " + escaped(value);
  if (report.shards > 1) page += ", shard " + std::to_string(report.shard) + " of " + std::to_string(report.shards);
  page += "</p>\n";
  if (const std::string others = otherRenderers(report); !others.empty())
    page += "<p class=\"quiet\">" + escaped(others) + "</p>\n";
  for (const std::string& remark : report.remarks) page += "<p class=\"bad\">" + escaped(remark) + "</p>\n";
  for (const std::string& stale : report.stale)
    page += "<p class=\"quiet\">a baseline of no job: " + escaped(stale) + "</p>\n";
  std::string rest;
  for (const JobResult& job : report.jobs) (job.status == JobStatus::passed ? rest : page) += article(job);
  const auto passed = std::ranges::count(report.jobs, JobStatus::passed, &JobResult::status);
  if (passed > 0)
    page += std::string("<details") + (report.good() ? " open" : "") + "><summary>" + std::to_string(passed) +
            " passed</summary>\n" + rest + "</details>\n";
  return page + "</body></html>\n";
}

// As Jenkins, GitLab and GitHub's actions read it: <failure> for pictures that differ, <error> where there is none.
std::string reportJunit(const RegressionReport& report) {
  const auto count = [&](auto test) { return std::to_string(std::ranges::count_if(report.jobs, test)); };
  const auto isError = [](const JobResult& job) { return job.status == JobStatus::failed; };
  const auto isFailure = [](const JobResult& job) { return !job.good() && job.status != JobStatus::failed; };
  double seconds = 0;
  for (const JobResult& job : report.jobs) seconds += job.milliseconds / 1000;
  const size_t remarks = report.remarks.empty() ? 0 : 1;
  std::string xml = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n<testsuite name=\"" +
                    escaped(report.suite) + "\" tests=\"" + std::to_string(report.jobs.size() + remarks) +
                    "\" failures=\"" + count(isFailure) + "\" errors=\"" +
                    std::to_string(std::ranges::count_if(report.jobs, isError) + static_cast<ptrdiff_t>(remarks)) +
                    "\" time=\"" + figure(seconds, "%.3f") + "\">\n";
  for (const JobResult& job : report.jobs) {
    xml += "<testcase classname=\"" + escaped(report.suite) + "\" name=\"" + escaped(job.name) + "\" time=\"" +
           figure(job.milliseconds / 1000, "%.3f") + "\"";
    if (job.good()) {
      xml += "/>\n";
      continue;
    }
    const char* element = isError(job) ? "error" : "failure";
    xml += std::string(">\n<") + element + " message=\"" + escaped(job.message) + "\">" + escaped(job.command);
    for (const auto& [name, value] : job.figures) xml += "\n" + escaped(name) + " " + figure(value);
    xml += std::string("</") + element + ">\n</testcase>\n";
  }
  for (size_t i = 0; i < remarks; ++i)
    xml += "<testcase classname=\"" + escaped(report.suite) + "\" name=\"(suite)\"><error message=\"" +
           escaped(report.remarks.front()) + "\"/></testcase>\n";
  return xml + "</testsuite>\n</testsuites>\n";
}

}  // namespace facet::compare
