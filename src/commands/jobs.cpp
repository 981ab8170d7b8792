#include "commands/jobs.hpp"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "base/nearest.hpp"
#include "base/text.hpp"
#include "commands/json_file.hpp"

namespace facet::commands {

namespace {

using nlohmann::json;

constexpr std::string_view ownKeys[] = {"model", "output", "stats"};

Result<std::string> textAt(const json& job, const char* key, const std::string& name, const std::string& pointer,
                           bool required) {
  const auto found = job.find(key);
  if (found == job.end()) {
    if (!required) return std::string();
    return fail(name, pointer, std::string("the job has no \"") + key + "\"", "every job names a model and an output");
  }
  if (!found->is_string() || found->get_ref<const std::string&>().empty()) {
    return fail(name, pointer + "/" + key, "this is no file name", "give a text that is not empty");
  }
  return found->get<std::string>();
}

Result<Job> parseJob(const json& object, const std::string& name, const std::string& pointer,
                     const std::filesystem::path& folder, const PictureArguments& overrides) {
  if (!object.is_object()) {
    return fail(name, pointer, std::string("a job is an object, this is of type ") + object.type_name(),
                "write {\"model\": ..., \"output\": ...}");
  }
  const Result<std::string> model = textAt(object, "model", name, pointer, true);
  if (!model) return tl::unexpected(model.error());
  const Result<std::string> output = textAt(object, "output", name, pointer, true);
  if (!output) return tl::unexpected(output.error());
  const Result<std::string> stats = textAt(object, "stats", name, pointer, false);
  if (!stats) return tl::unexpected(stats.error());

  Job job;
  job.model = model->starts_with("builtin:") ? *model : (folder / *model).string();
  job.output = folder / *output;
  if (!stats->empty()) job.stats = folder / *stats;
  const Result<io::PictureFormat> format = formatOfName(job.output);
  if (!format) return fail(name, pointer + "/output", format.error().problem, format.error().remedy);
  job.format = *format;
  if (auto set = applyObject(object, ownKeys, folder.string(), name, pointer, job.settings); !set) {
    return tl::unexpected(set.error());
  }
  if (auto together = options::checkTogether(job.settings); !together) {
    return fail(name, pointer, together.error().place + ": " + together.error().problem, together.error().remedy);
  }
  if (auto set = options::apply(overrides, job.settings); !set) return tl::unexpected(set.error());
  return job;
}

Result<const json*> listOf(const json& document, const std::string& name) {
  if (document.is_array()) return &document;
  const std::string remedy = "write {\"jobs\": [...]} or just the array";
  if (!document.is_object() || !document.contains("jobs")) return fail(name, {}, "there are no jobs", remedy);
  constexpr std::string_view known[] = {"jobs"};
  for (const auto& [key, value] : document.items()) {
    if (key != "jobs") return fail(name, "/" + pointerToken(key), "there is no such key", suggestion(key, known));
  }
  if (!document["jobs"].is_array()) return fail(name, "/jobs", "this is no array", remedy);
  return &document["jobs"];
}

}  // namespace

Result<io::PictureFormat> formatOfName(const std::filesystem::path& output) {
  if (const auto format = io::pictureFormat(output)) return *format;
  return fail({}, {}, inQuotes(output.string()) + " is no picture's name",
              "end it in " + io::pictureEndings(false) + " (after tone mapping) or .exr (scene-linear)");
}

Result<std::vector<Job>> parseJobs(std::string_view text, const std::string& name, const std::filesystem::path& folder,
                                   const PictureArguments& overrides) {
  const Result<json> document = parseJson(text, name);
  if (!document) return tl::unexpected(document.error());
  const Result<const json*> list = listOf(*document, name);
  if (!list) return tl::unexpected(list.error());
  if ((*list)->empty()) return fail(name, {}, "there are no jobs", "list at least one");

  const std::string above = document->is_array() ? "/" : "/jobs/";
  std::vector<Job> jobs;
  std::map<std::string, std::string> writers;  // file -> pointer of what writes it
  for (size_t i = 0; i < (*list)->size(); ++i) {
    const std::string pointer = above + std::to_string(i);
    Result<Job> job = parseJob((**list)[i], name, pointer, folder, overrides);
    if (!job) return tl::unexpected(job.error());
    for (const auto& [file, key] : {std::pair(job->output, "/output"), std::pair(job->stats, "/stats")}) {
      if (file.empty()) continue;
      const auto [other, added] = writers.emplace(file.lexically_normal().string(), pointer + key);
      if (!added) return fail(name, pointer + key, "the file is also written by " + other->second, "name another file");
    }
    jobs.push_back(std::move(*job));
  }
  return jobs;
}

Result<std::vector<Job>> readJobs(const std::filesystem::path& file, const PictureArguments& overrides) {
  const Result<std::string> text = readJsonText(file);
  if (!text) return tl::unexpected(text.error());
  return parseJobs(*text, file.string(), file.parent_path(), overrides);
}

Result<std::string> numberedName(const std::string& pattern, int number) {
  std::string name;
  int numbers = 0;
  const auto wrong = [&] {
    return fail({}, "-o", pattern + " does not say where the frame's number goes", "give a name like frame_%04d.png");
  };
  for (size_t i = 0; i < pattern.size(); ++i) {
    if (pattern[i] != '%') {
      name += pattern[i];
      continue;
    }
    const std::string_view rest = std::string_view(pattern).substr(i + 1);
    if (rest.starts_with('%')) {
      name += '%', ++i;
      continue;
    }
    size_t width = 0, length = 0;  // of what follows the percent sign, "d" included
    if (rest.starts_with('d'))
      length = 1;
    else if (rest.size() >= 3 && rest[0] == '0' && rest[1] >= '1' && rest[1] <= '9' && rest[2] == 'd')
      width = static_cast<size_t>(rest[1] - '0'), length = 3;
    if (length == 0) return wrong();
    const std::string digits = std::to_string(number);
    name += std::string(width > digits.size() ? width - digits.size() : 0, '0') + digits;
    ++numbers, i += length;
  }
  if (numbers != 1) return wrong();
  return name;
}

}  // namespace facet::commands
