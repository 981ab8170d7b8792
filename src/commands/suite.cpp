#include "commands/suite.hpp"

#include <fnmatch.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "base/nearest.hpp"
#include "base/text.hpp"
#include "commands/json_file.hpp"

namespace facet::commands {

namespace {

using nlohmann::json;

constexpr std::string_view jobKeys[] = {"name", "model", "tolerance"};
constexpr std::string_view rendererKeys[] = {"name", "matches", "tolerance"};
constexpr std::string_view defaultKeys[] = {"tolerance"};

Result<void> applyTolerance(const json& object, const std::string& file, const std::string& pointer,
                            compare::Limits& limits) {
  const auto given = object.find("tolerance");
  if (given == object.end()) return {};
  const std::string place = pointer + "/tolerance";
  if (!given->is_object())
    return fail(file, place, "this is no object", "write {\"flip\": 0.01} or another metric and its limit");
  for (const auto& [key, value] : given->items()) {
    const compare::Metric* metric = compare::findMetric(key);
    if (!metric)
      return fail(file, place + "/" + pointerToken(key), "there is no such metric",
                  suggestion(key, compare::metricNames()));
    if (value.is_null()) {
      std::erase_if(limits, [&](const compare::Limit& limit) { return limit.metric == metric; });
      continue;
    }
    if (!value.is_number() || !(value.get<double>() >= 0))
      return fail(file, place + "/" + key, "this is no limit", "give a number from 0 on, or null for none");
    compare::setLimit(limits, *metric, value.get<double>());
  }
  return {};
}

Result<std::string> textAt(const json& job, const char* key, const std::string& file, const std::string& pointer) {
  const auto found = job.find(key);
  if (found == job.end())
    return fail(file, pointer, std::string("the job has no \"") + key + "\"", "every job has a name and a model");
  if (!found->is_string() || found->get_ref<const std::string&>().empty())
    return fail(file, pointer + "/" + key, "this is no name", "give a text that is not empty");
  return found->get<std::string>();
}

bool isFileName(std::string_view name) {
  const auto plain = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) || c == '-' || c == '_' || c == '.';
  };
  return name.size() <= 200 && name.front() != '.' && std::ranges::all_of(name, plain);
}

struct Context {
  const std::string& file;
  const std::filesystem::path& folder;
  const PictureArguments& overrides;
};

Result<SuiteJob> parseJob(const json& object, const std::string& pointer, SuiteJob job, const Context& context) {
  if (!object.is_object())
    return fail(context.file, pointer, std::string("a job is an object, this is of type ") + object.type_name(),
                "write {\"name\": ..., \"model\": ...}");
  const Result<std::string> name = textAt(object, "name", context.file, pointer);
  if (!name) return tl::unexpected(name.error());
  if (!isFileName(*name))
    return fail(context.file, pointer + "/name", inQuotes(*name) + " makes no file name",
                "use only letters, digits and the signs - _ and dot");
  const Result<std::string> model = textAt(object, "model", context.file, pointer);
  if (!model) return tl::unexpected(model.error());
  job.name = *name;
  job.model = model->starts_with("builtin:") ? *model : (context.folder / *model).string();
  if (auto set = applyObject(object, jobKeys, context.folder.string(), context.file, pointer, job.settings); !set)
    return tl::unexpected(set.error());
  if (auto together = options::checkTogether(job.settings); !together)
    return fail(context.file, pointer, together.error().place + ": " + together.error().problem,
                together.error().remedy);
  if (auto set = applyTolerance(object, context.file, pointer, job.limits); !set) return tl::unexpected(set.error());
  if (auto set = options::apply(context.overrides, job.settings); !set) return tl::unexpected(set.error());
  return job;
}

Result<SuiteJob> parseDefaults(const json& document, const Context& context) {
  SuiteJob job;
  for (const auto& [name, most] : defaultTolerance) compare::setLimit(job.limits, *compare::findMetric(name), most);
  const auto given = document.find("defaults");
  if (given == document.end()) return job;
  if (!given->is_object()) return fail(context.file, "/defaults", "this is no object", "write {\"size\": \"128x128\"}");
  if (auto set = applyObject(*given, defaultKeys, context.folder.string(), context.file, "/defaults", job.settings);
      !set)
    return tl::unexpected(set.error());
  if (auto set = applyTolerance(*given, context.file, "/defaults", job.limits); !set)
    return tl::unexpected(set.error());
  return job;
}

Result<std::vector<SuiteRenderer>> parseRenderers(const json& document, const std::string& file) {
  std::vector<SuiteRenderer> renderers;
  const auto list = document.find("renderers");
  if (list == document.end()) return renderers;
  if (!list->is_array())
    return fail(file, "/renderers", "this is no list", "write [{\"name\": ..., \"matches\": \"*Mesa 25.*\"}]");
  for (size_t i = 0; i < list->size(); ++i) {
    const std::string pointer = "/renderers/" + std::to_string(i);
    const json& object = (*list)[i];
    const auto textOf = [&](const char* key) -> Result<std::string> {
      if (!object.is_object() || !object.contains(key) || !object[key].is_string() ||
          object[key].get_ref<const std::string&>().empty())
        return fail(file, pointer, std::string("the renderer has no \"") + key + "\"",
                    "every renderer has a name, and matches a pattern such as *Mesa 25.*");
      return object[key].get<std::string>();
    };
    const Result<std::string> name = textOf("name"), pattern = textOf("matches");
    if (!name) return tl::unexpected(name.error());
    if (!pattern) return tl::unexpected(pattern.error());
    for (const auto& [key, value] : object.items())
      if (std::ranges::find(rendererKeys, key) == std::end(rendererKeys))
        return fail(file, pointer + "/" + pointerToken(key), "there is no such key", suggestion(key, rendererKeys));
    if (!isFileName(*name))
      return fail(file, pointer + "/name", inQuotes(*name) + " makes no folder's name",
                  "use only letters, digits and the signs - _ and dot");
    if (std::ranges::find(renderers, *name, &SuiteRenderer::name) != renderers.end())
      return fail(file, pointer + "/name", "is there twice", "name each renderer differently");
    SuiteRenderer renderer{*name, *pattern, {}};
    if (auto set = applyTolerance(object, file, pointer, renderer.limits); !set) return tl::unexpected(set.error());
    renderers.push_back(std::move(renderer));
  }
  return renderers;
}

std::string folderName(const std::filesystem::path& folder) {
  std::error_code ignored;
  const std::filesystem::path whole = std::filesystem::weakly_canonical(folder, ignored);
  return (whole.has_filename() ? whole : folder).filename().string();
}

}  // namespace

const SuiteRenderer* Suite::rendererOf(const std::string& rendererText) const {
  const auto fits = [&](const SuiteRenderer& r) { return fnmatch(r.pattern.c_str(), rendererText.c_str(), 0) == 0; };
  const auto found = std::ranges::find_if(renderers, fits);
  return found == renderers.end() ? nullptr : &*found;
}

std::filesystem::path Suite::baseline(const std::string& job, const SuiteRenderer* renderer) const {
  const std::filesystem::path all = folder / "baselines";
  return (renderer ? all / renderer->name : all) / (job + ".png");
}

std::filesystem::path Suite::comparedBaseline(const std::string& job, const SuiteRenderer* renderer) const {
  std::error_code ignored;
  const std::filesystem::path own = baseline(job, renderer);
  return std::filesystem::exists(own, ignored) ? own : baseline(job);
}

compare::Limits limitsFor(const SuiteJob& job, const SuiteRenderer* renderer) {
  compare::Limits limits = job.limits;
  if (!renderer) return limits;
  for (const compare::Limit& wide : renderer->limits)
    for (compare::Limit& limit : limits)
      if (limit.metric == wide.metric) limit.most = std::max(limit.most, wide.most);
  return limits;
}

std::vector<std::string> staleBaselines(const Suite& suite) {
  std::set<std::filesystem::path> known;
  for (const SuiteJob& job : suite.jobs) {
    known.insert(suite.baseline(job.name));
    for (const SuiteRenderer& renderer : suite.renderers) known.insert(suite.baseline(job.name, &renderer));
  }
  std::vector<std::string> stale;
  std::error_code error;
  const std::filesystem::path all = suite.folder / "baselines";
  for (std::filesystem::recursive_directory_iterator entry(all, error), end; !error && entry != end;
       entry.increment(error))
    if (entry->path().extension() == ".png" && !known.contains(entry->path()))
      stale.push_back(entry->path().lexically_relative(all).string());
  std::ranges::sort(stale);
  return stale;
}

Result<Suite> parseSuite(std::string_view text, const std::string& name, const std::filesystem::path& folder,
                         const PictureArguments& overrides) {
  const Result<json> document = parseJson(text, name);
  if (!document) return tl::unexpected(document.error());
  if (!document->is_object()) return fail(name, {}, "there are no jobs", "write {\"jobs\": [...]}");
  constexpr std::string_view known[] = {"defaults", "jobs", "renderers"};
  for (const auto& [key, value] : document->items())
    if (std::ranges::find(known, key) == std::end(known))
      return fail(name, "/" + pointerToken(key), "there is no such key", suggestion(key, known));
  const auto list = document->find("jobs");
  if (list == document->end() || !list->is_array() || list->empty())
    return fail(name, {}, "there are no jobs", "write {\"jobs\": [...]} with at least one");
  const Context context{name, folder, overrides};
  const Result<SuiteJob> defaults = parseDefaults(*document, context);
  if (!defaults) return tl::unexpected(defaults.error());

  Result<std::vector<SuiteRenderer>> renderers = parseRenderers(*document, name);
  if (!renderers) return tl::unexpected(renderers.error());

  Suite suite{folder, folderName(folder), {}, std::move(*renderers)};
  std::map<std::string, std::string> places;  // name -> pointer
  for (size_t i = 0; i < list->size(); ++i) {
    const std::string pointer = "/jobs/" + std::to_string(i);
    Result<SuiteJob> job = parseJob((*list)[i], pointer, *defaults, context);
    if (!job) return tl::unexpected(job.error());
    job->index = static_cast<int>(i);
    const auto [other, added] = places.emplace(job->name, pointer);
    if (!added) return fail(name, pointer + "/name", "is also that of " + other->second, "name each job differently");
    if (i > 0 && job->settings.sources.shaderDir != suite.jobs.front().settings.sources.shaderDir)
      return fail(name, pointer + "/shader-dir", "differs from job to job", "give it to all, among the defaults");
    suite.jobs.push_back(std::move(*job));
  }
  return suite;
}

Result<Suite> readSuite(const std::filesystem::path& folder, const PictureArguments& overrides) {
  const std::filesystem::path file = folder / "suite.json";
  const Result<std::string> text = readJsonText(file);
  if (!text) return tl::unexpected(text.error());
  return parseSuite(*text, file.string(), folder, overrides);
}

}  // namespace facet::commands
