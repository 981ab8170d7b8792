#include "commands/regress_job.hpp"

#include <chrono>
#include <iostream>
#include <string>

#include "base/log.hpp"
#include "base/whole_file.hpp"
#include "base/whole_number.hpp"
#include "commands/commands.hpp"
#include "commands/confine.hpp"
#include "compare/compare.hpp"

namespace facet::commands {

namespace {

using compare::JobResult;
using compare::JobStatus;

// Without what belongs to this machine: the picture's name alone.
std::string commandOf(const SuiteJob& job) { return options::commandLine(job.settings, job.model, job.name + ".png"); }

std::vector<std::pair<std::string, double>> limitFigures(const compare::Limits& limits) {
  std::vector<std::pair<std::string, double>> figures;
  for (const compare::Limit& limit : limits) figures.emplace_back(limit.metric->name, limit.most);
  return figures;
}

struct Files {
  std::string picture, baseline, difference;
};

Files filesOf(const SuiteJob& job) { return {job.name + ".png", job.name + ".baseline.png", job.name + ".diff.png"}; }

Result<io::Pixels> render(const SuiteJob& job, frame::Session& session, JobResult& result) {
  Notes notes;
  Stages stages;
  Result<frame::Picture> picture = session.render(job.model, job.settings, {.display = true}, notes, stages);
  if (!picture) return tl::unexpected(picture.error());
  for (const Note& note : notes)
    if (note.severity == Note::Severity::warning) result.warnings.push_back(options::describe("", note));
  return std::move(picture->display);
}

// What the map of differences shows: what the first limit that is passed is about, else the first one of all.
std::string judgedBy(const std::vector<std::string>& passed, const SuiteJob& job) {
  std::string name = passed.empty() ? "" : passed.front().substr(0, passed.front().find(' '));
  if (name.empty() && !job.limits.empty()) name = job.limits.front().metric->name;
  return name.starts_with("flip") || name == "noticeable" ? "flip" : "display";
}

constexpr std::string_view rendererKeyword = "Renderer";

Result<void> compareWithBaseline(const Suite& suite, const SuiteJob& job, const io::Pixels& display,
                                 const std::filesystem::path& results, JobResult& result) {
  const SuiteRenderer* renderer = suite.rendererOf(result.renderer);
  const compare::Limits limits = limitsFor(job, renderer);
  result.limits = limitFigures(limits);
  const std::filesystem::path file = suite.comparedBaseline(job.name, renderer);
  std::error_code error;
  if (!std::filesystem::exists(file, error)) {
    result.status = JobStatus::missing;
    result.message = "there is no baseline; look at the picture and take it as such with --accept";
    return {};
  }
  const Files files = filesOf(job);
  if (Result<void> copied = copyWholeFile(file, results / files.baseline); !copied) return copied;
  result.baseline = files.baseline;
  result.baselineRenderer = baselineRenderer(file);
  const Result<io::RadianceImage> before = compare::readPicture(file);
  if (!before) return tl::unexpected(before.error());
  const io::RadianceImage after = compare::linearPicture(display);
  const Result<compare::Comparison> comparison = compare::comparePictures(*before, after);
  if (!comparison) {
    result.status = JobStatus::differs;
    result.message = comparison.error().problem;
    return {};
  }
  for (const compare::Metric& metric : compare::metrics())
    result.figures.emplace_back(metric.name, metric.value(*comparison));
  const std::vector<std::string> passed = compare::passedLimits(*comparison, limits);
  result.status = passed.empty() ? JobStatus::passed : JobStatus::differs;
  for (const std::string& phrase : passed) result.message += (result.message.empty() ? "" : ", ") + phrase;
  if (!passed.empty() && result.otherRenderer())
    result.message += "; the baseline was drawn by " + result.baselineRenderer;
  if (comparison->largest == 0) return {};
  result.differenceOf = judgedBy(passed, job);
  const bool flip = result.differenceOf == "flip";
  const Result<io::Pixels> map = flip ? compare::flipHeatMap(*before, after) : compare::heatMap(*before, after);
  if (!map) return tl::unexpected(map.error());
  result.difference = files.difference;
  return io::writePng(results / files.difference, *map);
}

Result<void> tryJob(const Suite& suite, const SuiteJob& job, const std::filesystem::path& results,
                    frame::Session& session, JobResult& result) {
  const Files files = filesOf(job);
  std::error_code ignored;
  for (const std::string& file : {files.picture, files.baseline, files.difference})
    std::filesystem::remove(results / file, ignored);  // of an earlier run
  const Result<io::Pixels> display = render(job, session, result);
  if (!display) return tl::unexpected(display.error());
  const io::PngText drawnBy{std::string(rendererKeyword), result.renderer};
  if (Result<void> written = io::writePng(results / files.picture, *display, {&drawnBy, 1}); !written) return written;
  result.picture = files.picture;
  return compareWithBaseline(suite, job, *display, results, result);
}

}  // namespace

std::string rendererText(const gl::ContextInfo& context) { return context.renderer + ", OpenGL " + context.version; }

std::string baselineRenderer(const std::filesystem::path& baseline) {
  return io::readPngText(baseline, rendererKeyword);
}

JobResult startedResult(const SuiteJob& job) {
  JobResult result;
  result.index = job.index;
  result.name = job.name;
  result.model = job.model;
  result.command = commandOf(job);
  result.limits = limitFigures(job.limits);
  return result;
}

Result<JobResult> runJob(const Suite& suite, const SuiteJob& job, const std::filesystem::path& results,
                         frame::Session& session) {
  JobResult result = startedResult(job);
  result.renderer = rendererText(session.context());
  const auto start = std::chrono::steady_clock::now();
  if (Result<void> done = tryJob(suite, job, results, session, result); !done) {
    if (gl::isOfDriver(done.error())) return tl::unexpected(done.error());
    result.status = JobStatus::failed;
    result.message = options::describe(done.error());
  }
  result.milliseconds = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  return result;
}

int answerJobs(const Suite& suite, const std::filesystem::path& results, const frame::SessionOptions& options,
               bool sandbox) {
  if (sandbox) keepDriverCacheApart();
  Result<std::unique_ptr<frame::Session>> session = frame::Session::create(options);
  if (!session) {
    log::error(describe(session.error()));
    return exitNoOpenGL;
  }
  if (sandbox) {
    Needed needed{{suite.folder}, {results}};
    for (const SuiteJob& job : suite.jobs) needPicture(needed, job.model, job.settings);
    confine(std::move(needed), options.diskCache);
  }
  for (std::string line; std::getline(std::cin, line);) {
    const std::optional<int> index = wholeNumber(line);
    if (!index || *index < 0 || *index >= static_cast<int>(suite.jobs.size())) return exitBadInput;
    const Result<JobResult> result = runJob(suite, suite.jobs[static_cast<size_t>(*index)], results, **session);
    if (!result) return badInput(result.error());  // the job's end; another process takes the next one
    std::cout << rendererText((*session)->context()) << '\t' << compare::jobText(*result) << std::endl;
  }
  return exitGood;
}

}  // namespace facet::commands
