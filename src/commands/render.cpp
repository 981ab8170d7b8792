#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "base/interrupt.hpp"
#include "base/log.hpp"
#include "base/text.hpp"
#include "base/whole_file.hpp"
#include "commands/commands.hpp"
#include "commands/config_file.hpp"
#include "commands/confine.hpp"
#include "commands/film.hpp"
#include "commands/jobs.hpp"
#include "commands/picture_arguments.hpp"
#include "commands/picture_output.hpp"
#include "commands/render_statistics.hpp"
#include "commands/shard.hpp"
#include "frame/session.hpp"
#include "options/remarks.hpp"

namespace facet::commands {

namespace {

struct RenderArguments {
  PictureArguments picture;
  std::string model, output, stats, jobs, shard, config;
  OutputOptions out;
  bool strict = false, noCache = false, glDebug = false, noSandbox = false, passTimes = false;
  FilmOptions film;
  int repeat = 0;
};

// What was repaired or is missing; true where there was a warning.
bool tell(const std::string& model, const Notes& notes) {
  bool warned = false;
  for (const Note& note : notes) {
    const std::string text = options::describe(model, note);
    if (note.severity == Note::Severity::warning)
      log::warning(text), warned = true;
    else
      log::debug(text);
  }
  return warned;
}

struct JobOutcome {
  bool warned = false;
  std::string reached;  // options::Remarks
};

// Since a stage was marked.
double wallMsSince(const Stages& stages, size_t marked) {
  double sum = 0;
  for (size_t i = marked; i < stages.all().size(); ++i) sum += stages.all()[i].wallMs;
  return sum;
}

// film: that the picture goes into; null: into its own file. pictureMs: what each picture until now has taken.
Result<JobOutcome> runJob(const Job& job, const RenderArguments& arguments, bool last, Film* film,
                          frame::Session& session, const Confined& confined, Stages stages,
                          std::vector<double>& pictureMs) {
  const size_t before = stages.all().size();
  Notes notes;
  const bool exr = job.format == io::PictureFormat::exr;
  frame::PictureRequest request = pictureRequest(job, arguments.out, arguments.repeat, last);
  request.passTimes = arguments.passTimes && !job.stats.empty();
  Result<frame::Picture> picture = session.render(job.model, job.settings, request, notes, stages);
  if (!picture) return tl::unexpected(picture.error());
  if (arguments.out.errorLayer && picture->standardError.pixels.empty())
    notes.push_back(
        {Note::Severity::warning, "",
         exr ? "--error-layer: the picture does not converge, and has no error to be told; give more than 16 "
               "--samples, or more than 4 with --visibility none or --light paths"
             : "--error-layer: only an EXR holds it; end -o in .exr"});
  const options::Remarks remarks = options::remarksOn(job.settings, picture->statistics, exr);
  notes.insert(notes.end(), remarks.notes.begin(), remarks.notes.end());
  const bool warned = tell(job.model, notes);
  const Result<void> written = film ? film->add(picture->display) : writeOutput(job, arguments.out, session, *picture);
  if (!written) return tl::unexpected(written.error());
  stages.mark("write");
  pictureMs.push_back(wallMsSince(stages, before));
  if (!job.stats.empty()) {
    nlohmann::ordered_json statistics = statisticsJson(job, session, *picture, stages, notes, confined);
    if (arguments.film.frames > 0) statistics["film"] = filmJson(arguments.film.fps, pictureMs);
    const std::string text = statistics.dump(2, ' ', false, nlohmann::json::error_handler_t::replace);
    if (Result<void> written = writeWholeFile(job.stats, text + "\n"); !written) return tl::unexpected(written.error());
  }
  return JobOutcome{warned, remarks.reached};
}

// A film's pictures are as a PNG's.
Result<void> chooseFormat(Job& job, const RenderArguments& arguments) {
  if (isFilm(job.output, arguments.film)) return {};
  if (isFilmName(job.output) && arguments.film.frames == 0)
    return fail({}, {}, inQuotes(job.output.string()) + " is a film's name", "give --frames N");
  return outputFormat(job.output, arguments.out).map([&](io::PictureFormat format) { job.format = format; });
}

Result<std::vector<Job>> listJobs(const RenderArguments& arguments) {
  if (!arguments.jobs.empty()) {
    if (arguments.film.frames > 0) return fail({}, "--frames", "does not go with --jobs", "give the jobs their times");
    if (!arguments.config.empty())
      return fail({}, "--config", "does not go with --jobs", "give the jobs their options");
    if (!arguments.model.empty() || !arguments.output.empty())
      return fail({}, "--jobs", "names models and outputs itself", "leave out MODEL and -o");
    const Result<Shard> shard = parseShard(arguments.shard.empty() ? "1/1" : arguments.shard);
    if (!shard) return tl::unexpected(shard.error());
    if (!arguments.out.format.empty())
      return fail({}, "--format", "is for standard output (-o -)", "the names of the jobs' pictures say it");
    const Result<std::vector<Job>> jobs = readJobs(arguments.jobs, arguments.picture);
    if (!jobs) return jobs;
    for (const Job& job : *jobs)
      if (Result<void> r = checkOutput(job, arguments.out); !r) return tl::unexpected(r.error());
    return shardOf(*jobs, *shard);
  }
  if (!arguments.shard.empty()) return fail({}, "--shard", "is a part of many pictures", "give --jobs FILE.json, too");
  if (arguments.model.empty()) return fail({}, "MODEL", "is missing", "give a .gltf or .glb file or builtin:spheres");
  if (arguments.passTimes && arguments.stats.empty())
    return fail({}, "--pass-times", "is told in statistics", "give --stats FILE, too");
  if (arguments.output.empty()) return fail({}, "-o", "is missing", "give -o PICTURE.png or -o PICTURE.exr");
  Job job{.model = arguments.model, .output = arguments.output, .stats = arguments.stats};
  if (Result<void> r = chooseFormat(job, arguments); !r) return tl::unexpected(r.error());
  PictureArguments given = arguments.picture;
  if (!arguments.config.empty() && arguments.config != "none")
    if (Result<void> r = applyConfig(arguments.config, job.model, given); !r) return tl::unexpected(r.error());
  if (Result<void> r = options::apply(given, job.settings); !r) return tl::unexpected(r.error());
  if (Result<void> r = options::checkTogether(job.settings); !r) return tl::unexpected(r.error());
  if (Result<void> r = checkOutput(job, arguments.out); !r) return tl::unexpected(r.error());
  if (arguments.film.frames > 0) return listFrames(job, arguments.film);
  for (const auto& [option, given] : {std::pair("--turntable", arguments.film.turntable),
                                      std::pair("--camera-path", !arguments.film.cameraPath.empty())})
    if (given) return fail({}, option, "is for several pictures", "give --frames N, too");
  return std::vector<Job>{job};
}

Confined confineTo(const std::vector<Job>& jobs, const RenderArguments& arguments) {
  if (arguments.noSandbox) return {"no: --no-sandbox", "no: --no-sandbox"};
  Needed needed;
  for (const Job& job : jobs) {
    needPicture(needed, job.model, job.settings);
    needOutput(needed, job.output), needOutput(needed, job.stats);
  }
  return confine(std::move(needed), !arguments.noCache);
}

std::string writtenOf(size_t pictures, size_t all) {
  return std::to_string(pictures) + " of " + std::to_string(all) + " pictures written";
}

std::string filmWords(size_t pictures, size_t all) {
  return "no film written, " + std::to_string(pictures) + " of " + std::to_string(all) + " pictures drawn";
}

int endFilm(Film& film, const Job& first, size_t pictures, size_t all, int status) {
  if (pictures < all) return log::error(filmWords(pictures, all)), status;
  if (const Result<void> ended = film.end(); !ended) return badInput(ended.error());
  log::info(first.output.string() + ": " + std::to_string(pictures) + " pictures");
  return status;
}

int runRender(const RenderArguments& arguments) {
  Stages stages;
  const Result<std::vector<Job>> jobs = listJobs(arguments);
  if (!jobs) return badInput(jobs.error());
  const std::string shaderDir = jobs->empty() ? "" : jobs->front().settings.sources.shaderDir;
  for (const Job& job : *jobs)
    if (job.settings.sources.shaderDir != shaderDir)
      return badInput(
          {arguments.jobs, "shader-dir", "differs from job to job", "give one for all, on the command line"});
  const frame::SessionOptions wished{
      .shaderDir = shaderDir, .diskCache = !arguments.noCache, .debug = arguments.glDebug};
  if (!arguments.noSandbox) keepDriverCacheApart();
  Result<std::unique_ptr<frame::Session>> session = frame::Session::create(wished);
  if (!session) {
    log::error(describe(session.error()));
    return exitNoOpenGL;
  }
  stages.mark("context");
  std::optional<Film> film;
  if (!jobs->empty() && isFilm(jobs->front().output, arguments.film)) {
    Result<Film> begun = Film::begin(jobs->front(), arguments.film, arguments.out);
    if (!begun) return badInput(begun.error());
    film.emplace(std::move(*begun));
  }
  const Confined confined = confineTo(*jobs, arguments);
  stages.mark("sandbox");
  int status = exitGood;
  size_t pictures = 0;  // written
  std::vector<double> pictureMs;
  const bool many = jobs->size() > 1;
  LastWords lastWords(writtenOf(0, jobs->size()));
  for (size_t i = 0; i < jobs->size(); ++i) {
    const Job& job = (*jobs)[i];
    const Result<JobOutcome> result = runJob(job, arguments, i + 1 == jobs->size(), film ? &*film : nullptr, **session,
                                             confined, i == 0 ? stages : Stages(), pictureMs);
    const std::string place = many ? std::to_string(i + 1) + "/" + std::to_string(jobs->size()) + " " : "";
    if (!result) {
      log::error(place + (many ? job.output.string() + ": " : "") + options::describe(result.error()));
      status = exitBadInput;
      if (film) break;  // it would lack a picture
      if (!gl::isOfDriver(result.error()) || i + 1 == jobs->size()) continue;
      session->reset();
      session = frame::Session::create(wished);
      if (session) continue;
      log::error(describe(session.error()));
      return exitNoOpenGL;
    }
    if (result->warned && arguments.strict) status = exitBadInput;
    lastWords.change(film ? filmWords(++pictures, jobs->size()) : writtenOf(++pictures, jobs->size()));
    if (!film) log::info(place + job.output.string() + result->reached);
  }
  if (film) return endFilm(*film, jobs->front(), pictures, jobs->size(), status);
  if (pictures < jobs->size() && many) log::error(writtenOf(pictures, jobs->size()));
  return status;
}

}  // namespace

std::function<int()> addRender(CLI::App& app) {
  auto arguments = std::make_shared<RenderArguments>();
  app.add_option("MODEL", arguments->model, "a .gltf or .glb file, or builtin:NAME")->type_name("MODEL");
  app.add_option("-o,--output", arguments->output,
                 "the picture: .png, .jpg, .webp, .avif (display) or .exr (scene-linear); - for standard output")
      ->type_name("FILE");
  app.add_option("--jobs", arguments->jobs, "many pictures in one process: a JSON list of jobs")->type_name("FILE");
  app.add_option("--shard", arguments->shard, "of --jobs only each N-th from the I-th on, for many machines")
      ->type_name("I/N");
  addConfig(app, arguments->config, "");
  app.add_option(
         "--stats", arguments->stats,
         "times, memory, work and what was left out, as JSON; of --frames the last picture's, with the time of each")
      ->type_name("FILE");
  app.add_option("--repeat", arguments->repeat, "draw N more frames, for timing")
      ->type_name("N")
      ->check(CLI::NonNegativeNumber);
  app.add_flag("--pass-times", arguments->passTimes,
               "in --stats, the GPU time of each pass of the last frame, which takes a little longer by that");
  addFilmOptions(app, arguments->film);
  addOutputOptions(app, arguments->out);
  app.add_flag("--strict", arguments->strict, "any warning makes the exit status 2");
  app.add_flag("--no-cache", arguments->noCache,
               "neither read nor write the caches of compiled shaders and of light tables");
  addNoSandbox(app, arguments->noSandbox);
  app.add_flag("--gl-debug", arguments->glDebug, "log OpenGL's debug messages");
  addPictureOptions(app, arguments->picture);
  return [arguments] { return runRender(*arguments); };
}

}  // namespace facet::commands
