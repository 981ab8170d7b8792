#include "commands/sweep_plan.hpp"

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "base/nearest.hpp"
#include "base/text.hpp"
#include "commands/picture_arguments.hpp"

namespace facet::commands {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view planKeys[] = {"models", "environments", "sizes", "samples", "methods",
                                         "common", "reference",    "seeds", "repeat"};
// That the plan itself varies.
constexpr std::string_view varied[] = {"env", "size", "samples", "seed", "max-error"};

struct Place {
  const std::string &name, &folder;
};

Result<void> applyOptions(const Json& object, std::span<const std::string_view> own, const Place& place,
                          const std::string& pointer, frame::PictureSettings& settings) {
  if (!object.is_object()) return fail(place.name, pointer, "this is no object", "give options of a picture by name");
  for (const auto& [key, value] : object.items())
    if (std::ranges::find(varied, key) != std::end(varied) && std::ranges::find(own, key) == own.end())
      return fail(place.name, pointer + "/" + pointerToken(key), "the sweep sets this itself",
                  "leave it out; see \"environments\", \"sizes\", \"samples\" and \"seeds\"");
  if (auto set = applyObject(object, own, place.folder, place.name, pointer, settings); !set) return set;
  if (auto together = options::checkTogether(settings); !together)
    return fail(place.name, pointer, together.error().place + ": " + together.error().problem, together.error().remedy);
  return {};
}

Result<int> wholeAt(const Json& value, int least, int most, const Place& place, const std::string& pointer) {
  if (!value.is_number_integer() || value < least || value > most)
    return fail(place.name, pointer, "is no whole number from " + std::to_string(least) + " to " + std::to_string(most),
                "give one");
  return value.get<int>();
}

Result<void> checkList(const Json& list, const Place& place, const std::string& pointer) {
  if (list.is_array() && !list.empty()) return {};
  return fail(place.name, pointer, "is no list, or an empty one", "list one at least");
}

Result<std::vector<std::string>> filesAt(const Json& list, const Place& place, const std::string& pointer) {
  if (auto checked = checkList(list, place, pointer); !checked) return tl::unexpected(checked.error());
  std::vector<std::string> files;
  for (size_t i = 0; i < list.size(); ++i) {
    if (!list[i].is_string() || list[i].get_ref<const std::string&>().empty())
      return fail(place.name, pointer + "/" + std::to_string(i), "is no file name", "give a file, or builtin:NAME");
    const auto& file = list[i].get_ref<const std::string&>();
    const bool path = !file.starts_with("builtin:") && file != "none";
    files.push_back(path ? (std::filesystem::path(place.folder) / file).string() : file);
    if (std::ranges::count(files, files.back()) > 1)
      return fail(place.name, pointer + "/" + std::to_string(i), "is there twice", "name each one once");
  }
  return files;
}

Result<void> readMethods(const Json& list, const frame::PictureSettings& common, const Place& place,
                         report::SweepPlan& plan) {
  constexpr std::string_view own[] = {"name"};
  if (auto checked = checkList(list, place, "/methods"); !checked) return checked;
  for (size_t i = 0; i < list.size(); ++i) {
    const std::string pointer = "/methods/" + std::to_string(i);
    if (!list[i].is_object() || !list[i].contains("name") || !list[i]["name"].is_string())
      return fail(place.name, pointer, "has no \"name\"", "name it, for tables and plots");
    report::SweepMethod method{list[i]["name"], common};
    if (std::ranges::find(plan.methods, method.name, &report::SweepMethod::name) != plan.methods.end())
      return fail(place.name, pointer + "/name", "is there twice", "give each method a name of its own");
    if (auto set = applyOptions(list[i], own, place, pointer, method.settings); !set) return set;
    plan.methods.push_back(std::move(method));
  }
  return {};
}

Result<void> readReference(const Json& object, const Place& place, report::SweepPlan& plan) {
  constexpr std::string_view own[] = {"samples"};
  constexpr int most = 1 << 20;
  if (auto set = applyOptions(object, own, place, "/reference", plan.reference); !set) return set;
  if (!object.contains("samples")) return {};
  const Result<int> samples = wholeAt(object["samples"], 2 * report::referenceBlock, most, place, "/reference/samples");
  if (!samples) return tl::unexpected(samples.error());
  plan.referenceSamples = *samples / report::referenceBlock * report::referenceBlock;
  return {};
}

Result<void> readSizes(const Json& list, const Place& place, report::SweepPlan& plan) {
  if (auto checked = checkList(list, place, "/sizes"); !checked) return checked;
  for (size_t i = 0; i < list.size(); ++i) {
    frame::PictureSettings read;
    const Json size = {{"size", list[i]}};
    if (auto set = applyObject(size, {}, place.folder, place.name, "/sizes/" + std::to_string(i), read); !set)
      return set;
    plan.sizes.emplace_back(read.frame.width, read.frame.height);
    if (std::ranges::count(plan.sizes, plan.sizes.back()) > 1)
      return fail(place.name, "/sizes/" + std::to_string(i), "is there twice", "name each one once");
  }
  return {};
}

}  // namespace

Json sweepDefaults() {
  return {{"models", {"builtin:spheres"}},
          {"environments", {"builtin:studio"}},
          {"sizes", {"128x128"}},
          {"samples", {4, 16, 64}},
          {"methods",
           {{{"name", "tables"}, {"visibility", "none"}},
            {{"name", "screen"}, {"visibility", "screen"}},
            {{"name", "rays"}, {"visibility", "rays"}},
            {{"name", "paths"}, {"light", "paths"}}}},
          {"common", Json::object()},
          {"reference", {{"light", "paths"}, {"samples", 1024}}},
          {"seeds", 2},
          {"repeat", 3}};
}

Result<Json> sweepMethod(const std::string& text) {
  const size_t colon = text.find(':');
  Json method = {{"name", text.substr(0, colon)}};
  if (colon == std::string::npos || colon == 0)
    return fail({}, "--method", inQuotes(text) + " has no name, or no options", "write NAME:option=value,option=value");
  for (const std::string_view part : split(std::string_view(text).substr(colon + 1), ',')) {
    const size_t equal = part.find('=');
    if (equal == std::string_view::npos && !part.empty())
      return fail({}, "--method", inQuotes(part) + " is no option with its value", "write option=value");
    if (!part.empty()) method[std::string(part.substr(0, equal))] = std::string(part.substr(equal + 1));
  }
  return method;
}

Result<report::SweepPlan> parseSweepPlan(const Json& document, const std::string& name, const std::string& folder) {
  const Place place{name, folder};
  if (!document.is_object()) return fail(name, {}, "this is no object", "see facet sweep --help");
  for (const auto& [key, value] : document.items())
    if (std::ranges::find(planKeys, key) == std::end(planKeys))
      return fail(name, "/" + pointerToken(key), "there is no such key", suggestion(key, planKeys));
  Json whole = sweepDefaults();
  for (const auto& [key, value] : document.items()) whole[key] = value;
  report::SweepPlan plan;
  frame::PictureSettings common;
  if (auto set = applyOptions(whole["common"], {}, place, "/common", common); !set) return tl::unexpected(set.error());
  plan.reference = common;
  Result<std::vector<std::string>> models = filesAt(whole["models"], place, "/models");
  if (!models) return tl::unexpected(models.error());
  plan.models = std::move(*models);
  Result<std::vector<std::string>> environments = filesAt(whole["environments"], place, "/environments");
  if (!environments) return tl::unexpected(environments.error());
  plan.environments = std::move(*environments);
  if (auto set = readSizes(whole["sizes"], place, plan); !set) return tl::unexpected(set.error());
  if (auto checked = checkList(whole["samples"], place, "/samples"); !checked) return tl::unexpected(checked.error());
  for (size_t i = 0; i < whole["samples"].size(); ++i) {
    const Result<int> samples = wholeAt(whole["samples"][i], 1, 4096, place, "/samples/" + std::to_string(i));
    if (!samples) return tl::unexpected(samples.error());
    plan.samples.push_back(*samples);
    if (std::ranges::count(plan.samples, *samples) > 1)
      return fail(name, "/samples/" + std::to_string(i), "is there twice", "name each one once");
  }
  if (auto set = readMethods(whole["methods"], common, place, plan); !set) return tl::unexpected(set.error());
  if (auto set = readReference(whole["reference"], place, plan); !set) return tl::unexpected(set.error());
  const Result<int> seeds = wholeAt(whole["seeds"], 1, 100, place, "/seeds"),
                    repeat = wholeAt(whole["repeat"], 0, 1000, place, "/repeat");
  if (!seeds) return tl::unexpected(seeds.error());
  if (!repeat) return tl::unexpected(repeat.error());
  plan.seeds = *seeds, plan.repeat = *repeat;
  return plan;
}

}  // namespace facet::commands
