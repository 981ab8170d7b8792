#include "compare/regression.hpp"

#include <algorithm>
#include <cstdio>
#include <map>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "base/origin_json.hpp"
#include "base/whole_file.hpp"

namespace facet::compare {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::pair<JobStatus, std::string_view> names[] = {{JobStatus::passed, "passed"},
                                                            {JobStatus::accepted, "accepted"},
                                                            {JobStatus::differs, "differs"},
                                                            {JobStatus::missing, "missing"},
                                                            {JobStatus::failed, "failed"}};

Json figuresJson(const std::vector<std::pair<std::string, double>>& figures) {
  Json object = Json::object();
  for (const auto& [name, value] : figures) object[name] = value;
  return object;
}

std::vector<std::pair<std::string, double>> figuresOf(const Json& object) {
  std::vector<std::pair<std::string, double>> figures;
  for (const auto& [name, value] : object.items()) figures.emplace_back(name, value.get<double>());
  return figures;
}

Json jobJson(const JobResult& job) {
  Json out;
  out["index"] = job.index;
  out["name"] = job.name;
  out["status"] = nameOf(job.status);
  if (!job.message.empty()) out["message"] = job.message;
  out["model"] = job.model;
  out["command"] = job.command;
  out["milliseconds"] = job.milliseconds;
  out["figures"] = figuresJson(job.figures);
  out["limits"] = figuresJson(job.limits);
  for (const auto& [key, file] : {std::pair("picture", &job.picture),
                                  {"baseline", &job.baseline},
                                  {"difference", &job.difference},
                                  {"differenceOf", &job.differenceOf},
                                  {"renderer", &job.renderer},
                                  {"baselineRenderer", &job.baselineRenderer}})
    if (!file->empty()) out[key] = *file;
  if (!job.warnings.empty()) out["warnings"] = job.warnings;
  return out;
}

// Of jobs and shards: whole, and no more than anybody has. Otherwise it throws.
int countOf(const Json& value) {
  const auto count = value.get_ref<const Json::number_integer_t&>();
  if (count < 0 || count > 1'000'000) throw std::out_of_range("count");
  return static_cast<int>(count);
}

// Throws what nlohmann throws; parseReport catches.
JobResult jobOf(const Json& object) {
  JobResult job;
  job.index = countOf(object.at("index"));
  job.name = object.at("name").get<std::string>();
  const auto status = object.at("status").get<std::string>();
  for (const auto& [value, name] : names)
    if (name == status) job.status = value;
  job.message = object.value("message", "");
  job.model = object.at("model").get<std::string>();
  job.command = object.at("command").get<std::string>();
  job.milliseconds = object.at("milliseconds").get<double>();
  job.figures = figuresOf(object.at("figures"));
  job.limits = figuresOf(object.at("limits"));
  job.picture = object.value("picture", "");
  job.baseline = object.value("baseline", "");
  job.difference = object.value("difference", "");
  job.differenceOf = object.value("differenceOf", "");
  job.renderer = object.value("renderer", "");
  job.baselineRenderer = object.value("baselineRenderer", "");
  job.warnings = object.value("warnings", std::vector<std::string>());
  return job;
}

}  // namespace

std::string_view nameOf(JobStatus status) {
  for (const auto& [value, name] : names)
    if (value == status) return name;
  return {};
}

bool RegressionReport::good() const { return remarks.empty() && std::ranges::all_of(jobs, &JobResult::good); }

std::string otherRenderers(const RegressionReport& report) {
  std::map<std::string, int> counts;
  for (const JobResult& job : report.jobs)
    if (job.otherRenderer()) ++counts[job.baselineRenderer];
  std::string text;
  for (const auto& [renderer, count] : counts)
    text += text.empty() ? std::to_string(count) + " of the baselines were drawn by " + renderer
                         : ", " + std::to_string(count) + " by " + renderer;
  return text;
}

std::string reportJson(const RegressionReport& report) {
  Json out;
  out["origin"] = originJson(report.origin);
  out["suite"] = report.suite;
  out["good"] = report.good();
  out["renderer"] = report.renderer;
  out["shard"] = {{"index", report.shard}, {"of", report.shards}};
  Json counts = Json::object();
  for (const auto& [status, name] : names) {
    const auto count = std::ranges::count(report.jobs, status, &JobResult::status);
    if (count > 0) counts[std::string(name)] = count;
  }
  out["counts"] = counts;
  out["remarks"] = report.remarks;
  out["stale"] = report.stale;
  out["jobs"] = Json::array();
  for (const JobResult& job : report.jobs) out["jobs"].push_back(jobJson(job));
  return out.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string jobText(const JobResult& job) { return jobJson(job).dump(-1, ' ', false, Json::error_handler_t::replace); }

Result<JobResult> parseJobText(std::string_view text) {
  try {
    return jobOf(Json::parse(text));
  } catch (const std::exception&) {
    return fail({}, {}, "no result came back");
  }
}

Result<RegressionReport> parseReport(std::string_view text, const std::string& name) {
  try {
    const Json object = Json::parse(text);
    RegressionReport report;
    report.suite = object.at("suite").get<std::string>();
    report.renderer = object.at("renderer").get<std::string>();
    report.shard = countOf(object.at("shard").at("index"));
    report.shards = countOf(object.at("shard").at("of"));
    report.remarks = object.at("remarks").get<std::vector<std::string>>();
    report.stale = object.at("stale").get<std::vector<std::string>>();
    for (const Json& job : object.at("jobs")) report.jobs.push_back(jobOf(job));
    return report;
  } catch (const std::exception&) {  // of the library, or a number that counts nothing
    return fail(name, "", "is no report of facet regress", "give folders that it has written");
  }
}

Result<RegressionReport> mergeReports(std::vector<RegressionReport> reports) {
  if (reports.empty()) return fail({}, {}, "there is nothing to merge", "give folders with results");
  std::ranges::stable_sort(reports, {}, &RegressionReport::shard);
  RegressionReport merged = std::move(reports.front());
  std::vector<int> present = {merged.shard};
  for (auto other = reports.begin() + 1; other != reports.end(); ++other) {
    if (other->suite != merged.suite || other->shards != merged.shards)
      return fail(other->suite, "shard " + std::to_string(other->shard) + " of " + std::to_string(other->shards),
                  "is not of suite " + merged.suite + " in " + std::to_string(merged.shards) + " shards",
                  "merge the shards of one run");
    if (other->shard == present.back())
      return fail(other->suite, "shard " + std::to_string(other->shard), "is there twice", "give each shard once");
    present.push_back(other->shard);
    std::ranges::move(other->jobs, std::back_inserter(merged.jobs));
    std::ranges::move(other->remarks, std::back_inserter(merged.remarks));
    for (std::string& name : other->stale)
      if (std::ranges::find(merged.stale, name) == merged.stale.end()) merged.stale.push_back(std::move(name));
    if (merged.renderer.empty()) merged.renderer = other->renderer;
  }
  for (int shard = 1; shard <= merged.shards; ++shard)
    if (std::ranges::find(present, shard) == present.end())
      merged.remarks.push_back("shard " + std::to_string(shard) + " of " + std::to_string(merged.shards) +
                               " is missing");
  merged.shard = merged.shards = 1;
  std::ranges::stable_sort(merged.jobs, {}, &JobResult::index);
  return merged;
}

Result<void> writeReports(const RegressionReport& report, const std::filesystem::path& folder) {
  if (Result<void> r = writeWholeFile(folder / "report.json", reportJson(report)); !r) return r;
  if (Result<void> r = writeWholeFile(folder / "report.html", reportHtml(report)); !r) return r;
  return writeWholeFile(folder / "junit.xml", reportJunit(report));
}

void removeReports(const std::filesystem::path& folder) {
  std::error_code ignored;
  for (const char* name : {"report.json", "report.html", "junit.xml"}) std::filesystem::remove(folder / name, ignored);
}

}  // namespace facet::compare
