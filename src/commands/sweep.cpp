#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "base/disk_cache.hpp"
#include "base/interrupt.hpp"
#include "base/log.hpp"
#include "base/text.hpp"
#include "commands/commands.hpp"
#include "commands/confine.hpp"
#include "commands/json_file.hpp"
#include "commands/sweep_plan.hpp"
#include "commands/write_tables.hpp"
#include "frame/session.hpp"
#include "io/referenced_files.hpp"
#include "io/sources.hpp"
#include "options/picture_options.hpp"

namespace facet::commands {

namespace {

using Json = nlohmann::ordered_json;

struct SweepArguments {
  std::string file, output, shaderDir, reference;
  std::vector<std::string> models, environments, sizes, methods;
  std::vector<int> samples;
  std::optional<int> seeds, repeat;
  bool noSandbox = false;
};

// The plan's file, and what the command line says in the place of it.
Result<Json> sweepDocument(const SweepArguments& arguments) {
  Json document = Json::object();
  if (!arguments.file.empty()) {
    const Result<std::string> text = readJsonText(arguments.file);
    if (!text) return tl::unexpected(text.error());
    const Result<nlohmann::json> parsed = parseJson(*text, arguments.file);
    if (!parsed) return tl::unexpected(parsed.error());
    if (!parsed->is_object()) return fail(arguments.file, {}, "this is no object", "see facet sweep --help");
    document = *parsed;
  }
  const bool inFolder = !arguments.file.empty();  // the plan's paths are below its folder, ours below where we are
  const auto absolute = [&](const std::vector<std::string>& files) {
    Json list = Json::array();
    for (const std::string& file : files)
      list.push_back(!inFolder || file.starts_with("builtin:") || file == "none"
                         ? file
                         : std::filesystem::absolute(file).string());
    return list;
  };
  if (!arguments.models.empty()) document["models"] = absolute(arguments.models);
  if (!arguments.environments.empty()) document["environments"] = absolute(arguments.environments);
  if (!arguments.sizes.empty()) document["sizes"] = arguments.sizes;
  if (!arguments.samples.empty()) document["samples"] = arguments.samples;
  if (arguments.seeds) document["seeds"] = *arguments.seeds;
  if (arguments.repeat) document["repeat"] = *arguments.repeat;
  if (!arguments.methods.empty()) document["methods"] = Json::array();
  for (const std::string& text : arguments.methods) {
    const Result<Json> method = sweepMethod(text);
    if (!method) return method;
    document["methods"].push_back(*method);
  }
  if (!arguments.reference.empty()) {
    Result<Json> reference = sweepMethod("reference:" + arguments.reference);
    if (!reference) return reference;
    reference->erase("name");
    if (reference->contains("samples")) {
      const Result<int> samples = parseWhole((*reference)["samples"].get<std::string>(), 1, 1 << 20);
      if (!samples) return fail({}, "--reference", "samples: " + samples.error().problem, samples.error().remedy);
      (*reference)["samples"] = *samples;
    }
    document["reference"] = *reference;
  }
  return document;
}

// Where a file lies, how long it and those beside it are that it names, and when they were written: other contents are
// another key.
std::string contentsOf(const std::string& source) {
  namespace fs = std::filesystem;
  if (source.starts_with(io::builtinPrefix) || source == "none") return {};
  std::vector<fs::path> files = {source};
  for (const fs::path& file : io::referencedFiles(source)) files.push_back(file);
  std::string text;
  for (const fs::path& file : files) {
    std::error_code ignored;
    const auto written = fs::last_write_time(file, ignored).time_since_epoch().count();
    text += "\n" + fs::absolute(file, ignored).string() + " " + std::to_string(fs::file_size(file, ignored)) + " " +
            std::to_string(written);
  }
  return text;
}

report::SweepTools sweepTools(frame::Session& session, const std::filesystem::path& folder) {
  Origin origin = gl::originOn(session.context());
  origin.date.clear();
  const std::string driver = session.context().renderer + " " + session.context().version;
  return {.draw =
              [&session](const std::string& model, const frame::PictureSettings& settings, int repeat) {
                Notes notes;
                Stages stages;
                return session.render(model, settings, {.radiance = true, .repeat = repeat}, notes, stages);
              },
          .key =
              [driver](const std::string& model, const frame::PictureSettings& settings) {
                return buildId() + "\n" + driver + "\n" + options::commandLine(settings, model, "picture.exr") +
                       contentsOf(model) + contentsOf(settings.sources.environment);
              },
          .origin = origin,
          .folder = folder,
          .progress = [](const std::string& what) { log::info(what); }};
}

void confineTo(const report::SweepPlan& plan, const SweepArguments& arguments) {
  Needed needed;
  for (const std::string& model : plan.models) needPicture(needed, model, plan.reference);
  for (const report::SweepMethod& method : plan.methods) needPicture(needed, {}, method.settings);
  for (const std::string& environment : plan.environments) {
    frame::PictureSettings settings;
    settings.sources.environment = environment, settings.sources.shaderDir = arguments.shaderDir;
    needPicture(needed, {}, settings);
  }
  needOutputFolder(needed, arguments.output);
  confine(std::move(needed), true);
}

int runSweep(const SweepArguments& arguments) {
  if (arguments.output.empty()) return badInput({{}, "-o", "is missing", "name a folder for figures and references"});
  const Result<Json> document = sweepDocument(arguments);
  if (!document) return badInput(document.error());
  const std::string name = arguments.file.empty() ? "facet sweep" : arguments.file;
  const Result<report::SweepPlan> plan =
      parseSweepPlan(*document, name, std::filesystem::path(arguments.file).parent_path().string());
  if (!plan) return badInput(plan.error());
  if (!arguments.noSandbox) keepDriverCacheApart();
  Result<std::unique_ptr<frame::Session>> session = frame::Session::create({.shaderDir = arguments.shaderDir});
  if (!session) {
    log::error(describe(session.error()));
    return exitNoOpenGL;
  }
  if (!arguments.noSandbox) confineTo(*plan, arguments);
  LastWords lastWords("no row was measured");
  constexpr std::string_view table[] = {"sweep"};
  if (const Result<void> begun = beginReport(arguments.output, table); !begun) return badInput(begun.error());
  report::SweepTools tools = sweepTools(**session, arguments.output);
  tools.measured = [&](size_t rows, size_t all) {
    lastWords.change(std::to_string(rows) + " of " + std::to_string(all) +
                     " rows are measured and kept, and there is no report; the same command goes on from there");
  };
  const auto measure = report::measureSweep(*plan, tools);
  if (!measure) return badInput(measure.error());
  Origin origin = gl::originOn((*session)->context());
  origin.seed = 0;
  const Result<void> written = writeReport(arguments.output, report::sweepReport(*plan, measure->rows), origin);
  if (!written) return badInput(written.error());
  int status = exitGood;
  for (const Error& error : measure->errors) status = badInput(error);
  return status;
}

}  // namespace

std::function<int()> addSweep(CLI::App& app) {
  auto arguments = std::make_shared<SweepArguments>();
  const auto list = [&](const std::string& name, auto& values, const std::string& help, const std::string& type) {
    app.add_option(name, values, help)->delimiter(',')->type_name(type)->expected(1, -1)->allow_extra_args(false);
  };
  app.add_option("FILE", arguments->file, "a plan as JSON; options below replace what it says")->type_name("FILE.json");
  list("--models", arguments->models, "files or builtin:NAME, with commas between (builtin:spheres)", "MODEL,...");
  list("--environments", arguments->environments, "likewise (builtin:studio)", "ENV,...");
  list("--sizes", arguments->sizes, "of the pictures (128x128)", "WxH,...");
  list("--samples", arguments->samples, "samples a pixel (4,16,64)", "N,...");
  app.add_option("--method", arguments->methods,
                 "a name and options of a picture; several times for several (tables, screen, rays, paths)")
      ->type_name("WORDS")
      ->delimiter('\n')
      ->take_all();
  app.add_option("--reference", arguments->reference,
                 "options of the reference, and its samples, which later runs may raise (light=paths,samples=1024)")
      ->type_name("OPTION=VALUE,...");
  app.add_option("--seeds", arguments->seeds, "pictures of each method, for the error's deviation (2)")->type_name("N");
  app.add_option("--repeat", arguments->repeat, "further frames, for timing (3)")->type_name("N");
  app.add_option("-o,--output", arguments->output,
                 "a folder: sweep.csv, report.md and .json, plots; references and what is measured stay in it, and a "
                 "run that was ended goes on")
      ->type_name("DIR");
  app.add_option("--shader-dir", arguments->shaderDir, "read the shaders from here")->type_name("DIR");
  addNoSandbox(app, arguments->noSandbox);
  return [arguments] { return runSweep(*arguments); };
}

}  // namespace facet::commands
