#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <memory>
#include <thread>
#include <utility>
#include <vector>

#include "base/interrupt.hpp"
#include "base/log.hpp"
#include "base/process_pool.hpp"
#include "base/whole_file.hpp"
#include "commands/commands.hpp"
#include "commands/confine.hpp"
#include "commands/json_file.hpp"
#include "commands/number_check.hpp"
#include "commands/regress_job.hpp"
#include "commands/shard.hpp"
#include "commands/suite.hpp"
#include "options/picture_options.hpp"

namespace facet::commands {

namespace {

namespace fs = std::filesystem;
using compare::JobResult;
using compare::JobStatus;
using compare::RegressionReport;

struct RegressArguments {
  std::string folder, results, filter, shard = "1/1", shaderDir;
  std::vector<std::string> merge;
  bool accept = false, acceptAll = false, noCache = false, worker = false, noSandbox = false;
  int processes = 0;  // 0: chosen
  double timeout = 120;
};

// ---- Progress -------------------------------------------------------------------------------------------------------

std::string summary(const JobResult& job) {
  std::string text = std::string(compare::nameOf(job.status)) + " " + job.name;
  if (!job.message.empty()) return text + ": " + job.message;
  const auto flip = std::ranges::find(job.figures, "flip", &std::pair<std::string, double>::first);
  char figures[64] = "";
  if (flip != job.figures.end()) std::snprintf(figures, sizeof figures, ", FLIP %.4f", flip->second);
  return text + figures;
}

// A bar on a terminal, with lines above it for what is not good; else a line for each job.
class Progress {
 public:
  explicit Progress(size_t count) : count_(count), terminal_(isatty(STDERR_FILENO) != 0) {}
  ~Progress() { clear(); }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void tell(const JobResult& job) {
    ++done_;
    const std::string place = std::to_string(done_) + "/" + std::to_string(count_) + " ";
    if (!terminal_ || job.status != JobStatus::passed) {
      clear();
      job.good() ? log::info(place + summary(job)) : log::error(place + summary(job));
    }
    if (!terminal_ || log::level() < log::Level::info) return;
    constexpr size_t width = 30;
    const size_t full = done_ * width / count_;
    std::fprintf(stderr, "\r\033[K[%s%s] %s%s", std::string(full, '#').c_str(), std::string(width - full, '.').c_str(),
                 place.c_str(), job.name.c_str());
    shown_ = true;
  }

 private:
  void clear() {
    if (shown_) std::fputs("\r\033[K", stderr);
    shown_ = false;
  }

  size_t count_, done_ = 0;
  bool terminal_, shown_ = false;
};

// ---- Running --------------------------------------------------------------------------------------------------------

Result<Suite> chosenSuite(const RegressArguments& arguments) {
  PictureArguments overrides;
  if (!arguments.shaderDir.empty()) overrides["shader-dir"] = arguments.shaderDir;
  return readSuite(arguments.folder, overrides);
}

Result<std::vector<SuiteJob>> chosenJobs(const Suite& suite, const RegressArguments& arguments) {
  const Result<Shard> shard = parseShard(arguments.shard);
  if (!shard) return tl::unexpected(shard.error());
  std::vector<SuiteJob> jobs;
  for (const SuiteJob& job : suite.jobs)
    if (job.name.find(arguments.filter) != std::string::npos) jobs.push_back(job);
  if (jobs.empty())
    return fail({}, "--filter", "no job's name contains '" + arguments.filter + "'",
                "see " + suite.folder.string() + "/suite.json");
  return shardOf(jobs, *shard);
}

fs::path resultsFolder(const RegressArguments& arguments) {
  return arguments.results.empty() ? fs::path(arguments.folder) / "results" : fs::path(arguments.results);
}

Result<void> makeFolder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) return fail(folder.string(), "", "cannot be made: " + error.message(), "choose another with -o");
  return {};
}

// Of two runs into one folder one has to wait: the report would be the last one's with pictures of both.
class FolderLock {
 public:
  static Result<FolderLock> take(const fs::path& folder) {
    FolderLock lock(open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (lock.fd_ >= 0 && flock(lock.fd_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK)
      return fail(folder.string(), "", "another facet regress is writing there",
                  "wait for its end, or choose another folder with -o");
    return lock;  // where a file system has no locks, there is none
  }
  FolderLock(FolderLock&& other) noexcept : fd_(std::exchange(other.fd_, -1)) {}
  FolderLock& operator=(FolderLock&&) = delete;
  ~FolderLock() {
    if (fd_ >= 0) close(fd_);
  }

 private:
  explicit FolderLock(int fd) : fd_(fd) {}
  int fd_ = -1;
};

// A software renderer uses every core by itself; processes beside each other fill the gaps of its reading, compiling
// and comparing.
int chosenProcesses(int wanted) {
  if (wanted > 0) return wanted;
  return static_cast<int>(std::clamp(std::thread::hardware_concurrency(), 1u, 4u));
}

PoolOptions poolOptions(const RegressArguments& arguments) {
  PoolOptions options;
  options.command = {ownProgram(), "regress", arguments.folder, "--worker", "-o", resultsFolder(arguments).string()};
  if (!arguments.shaderDir.empty())
    options.command.insert(options.command.end(), {"--shader-dir", arguments.shaderDir});
  if (arguments.noCache) options.command.emplace_back("--no-cache");
  if (arguments.noSandbox) options.command.emplace_back("--no-sandbox");
  options.processes = chosenProcesses(arguments.processes);
  options.secondsPerTask = arguments.timeout;
  options.hopelessStatus = exitNoOpenGL;
  return options;
}

JobResult resultOf(const SuiteJob& job, const TaskOutcome& outcome, std::string& renderer) {
  JobResult result = startedResult(job);
  result.milliseconds = outcome.milliseconds;
  if (!outcome.problem.empty()) {
    result.message = "the process that rendered it " + outcome.problem;
    return result;
  }
  const size_t tab = outcome.answer.find('\t');
  const Result<JobResult> answered = compare::parseJobText(std::string_view(outcome.answer).substr(tab + 1));
  if (!answered) {
    result.message = answered.error().problem;
    return result;
  }
  if (tab != std::string::npos) renderer = outcome.answer.substr(0, tab);
  return *answered;
}

// ---- Baselines ------------------------------------------------------------------------------------------------------

bool isToBeAccepted(const JobResult& job, const RegressArguments& arguments) {
  if (job.picture.empty()) return false;
  if (job.status == JobStatus::differs || job.status == JobStatus::missing)
    return arguments.accept || arguments.acceptAll;
  return arguments.acceptAll && !job.difference.empty();
}

Result<void> accept(const Suite& suite, const fs::path& results, JobResult& job) {
  const fs::path file = suite.baseline(job.name, suite.rendererOf(job.renderer));
  if (Result<void> made = makeFolder(file.parent_path()); !made) return made;
  if (Result<void> copied = copyWholeFile(results / job.picture, file); !copied) return copied;
  const std::string before = job.status == JobStatus::missing ? "a new baseline" : "the baseline is replaced";
  job.message = before + (job.status == JobStatus::missing || job.message.empty() ? "" : ": " + job.message);
  job.status = JobStatus::accepted;
  return {};
}

// ---- The end --------------------------------------------------------------------------------------------------------

int finish(const RegressionReport& report, const fs::path& results) {
  if (Result<void> written = compare::writeReports(report, results); !written) return badInput(written.error());
  if (const std::string others = compare::otherRenderers(report); !others.empty())
    log::info(others + "; now it is " + report.renderer);
  for (const std::string& name : report.stale)
    log::warning(report.suite + "/baselines/" + name + " belongs to no job; delete it, or add the job again");
  const auto bad = std::ranges::count_if(report.jobs, [](const JobResult& job) { return !job.good(); });
  const auto accepted = std::ranges::count(report.jobs, JobStatus::accepted, &JobResult::status);
  std::string text = std::to_string(report.jobs.size() - static_cast<size_t>(bad)) + " of " +
                     std::to_string(report.jobs.size()) + " good";
  if (accepted > 0) text += ", " + std::to_string(accepted) + " baselines written";
  for (const std::string& remark : report.remarks) text += ", but " + remark;
  text += "; " + (results / "report.html").string();
  report.remarks.empty() ? log::info(text) : log::error(text);
  return report.good() ? exitGood : exitFailed;
}

int runSuite(const RegressArguments& arguments) {
  const Result<Suite> suite = chosenSuite(arguments);
  if (!suite) return badInput(suite.error());
  const Result<std::vector<SuiteJob>> jobs = chosenJobs(*suite, arguments);
  if (!jobs) return badInput(jobs.error());
  const fs::path results = resultsFolder(arguments);
  if (Result<void> made = makeFolder(results); !made) return badInput(made.error());
  const Result<FolderLock> lock = FolderLock::take(results);
  if (!lock) return badInput(lock.error());
  compare::removeReports(results);
  removeParts(results);

  RegressionReport report;
  report.origin = originOfProcess();
  report.suite = suite->name;
  report.shard = parseShard(arguments.shard)->index, report.shards = parseShard(arguments.shard)->count;
  report.stale = staleBaselines(*suite);
  report.jobs.resize(jobs->size());
  std::vector<std::string> tasks;
  for (const SuiteJob& job : *jobs) tasks.push_back(std::to_string(job.index));
  Result<void> accepted;
  Result<void> ran;
  size_t done = 0;
  const InterruptGuard guard;
  {
    Progress progress(jobs->size());
    ran = distribute(poolOptions(arguments), tasks, [&](size_t i, const TaskOutcome& outcome) {
      JobResult& job = report.jobs[i] = resultOf((*jobs)[i], outcome, report.renderer);
      if (isToBeAccepted(job, arguments)) {
        if (Result<void> taken = accept(*suite, results, job); !taken) {
          accepted = taken;
          job.status = JobStatus::failed, job.message = options::describe(taken.error());
        }
      }
      progress.tell(job);
      ++done;
    });
  }
  if (const int signal = interruptedBy(); !ran && signal != 0) {
    log::error("ended by " + signalName(signal) + ": " + std::to_string(done) + " of " + std::to_string(jobs->size()) +
               " jobs were done, and there is no report; run it again");
    return exitStatusOf(signal);
  }
  if (!ran) {
    // A process of ours has said it as a line of the log.
    std::string said = ran.error().file.empty() ? ran.error().problem : describe(ran.error());
    if (constexpr std::string_view prefix = "facet: error: "; said.starts_with(prefix)) said.erase(0, prefix.size());
    log::error(said);
    return exitNoOpenGL;
  }
  const int status = finish(report, results);
  return accepted ? status : badInput(accepted.error());
}

Result<void> copyPictures(const RegressionReport& report, const fs::path& from, const fs::path& to) {
  for (const JobResult& job : report.jobs) {
    for (const std::string& name : {job.picture, job.baseline, job.difference}) {
      if (name.empty()) continue;
      if (fs::path(name).filename() != name)
        return fail((from / "report.json").string(), "", "names the picture '" + name + "', which is no file name",
                    "give folders that facet regress has written");
      std::error_code ignored;
      if (fs::equivalent(from / name, to / name, ignored)) continue;
      if (Result<void> copied = copyWholeFile(from / name, to / name); !copied) return copied;
    }
  }
  return {};
}

int runMerge(const RegressArguments& arguments) {
  if (!arguments.folder.empty())
    return badInput({{}, "DIR", "does not go with --merge", "give result folders after --merge, and -o"});
  if (arguments.results.empty()) return badInput({{}, "-o", "is missing", "name a folder for the merged results"});
  if (Result<void> made = makeFolder(arguments.results); !made) return badInput(made.error());
  const Result<FolderLock> lock = FolderLock::take(arguments.results);
  if (!lock) return badInput(lock.error());
  std::vector<RegressionReport> reports;
  for (const std::string& folder : arguments.merge) {
    const fs::path file = fs::path(folder) / "report.json";
    const Result<std::string> text = readJsonText(file);
    if (!text) return badInput(text.error());
    Result<RegressionReport> report = compare::parseReport(*text, file.string());
    if (!report) return badInput(report.error());
    if (Result<void> copied = copyPictures(*report, folder, arguments.results); !copied)
      return badInput(copied.error());
    reports.push_back(std::move(*report));
  }
  const Result<RegressionReport> merged = compare::mergeReports(std::move(reports));
  if (!merged) return badInput(merged.error());
  return finish(*merged, arguments.results);
}

int runRegress(const RegressArguments& arguments) {
  if (!arguments.merge.empty()) return runMerge(arguments);
  if (arguments.folder.empty()) return badInput({{}, "DIR", "is missing", "give the folder of a suite.json"});
  if (!arguments.worker) return runSuite(arguments);
  const Result<Suite> suite = chosenSuite(arguments);
  if (!suite) return badInput(suite.error());
  const std::string shaders = suite->jobs.front().settings.sources.shaderDir;
  return answerJobs(*suite, resultsFolder(arguments), {.shaderDir = shaders, .diskCache = !arguments.noCache},
                    !arguments.noSandbox);
}

}  // namespace

std::function<int()> addRegress(CLI::App& app) {
  auto arguments = std::make_shared<RegressArguments>();
  app.add_option("DIR", arguments->folder, "folder of suite.json and baselines/")->type_name("DIR");
  app.add_option("-o,--output", arguments->results, "folder for pictures and reports (DIR/results)")->type_name("DIR");
  app.add_flag("--accept", arguments->accept, "what is beyond its limits or new becomes the baseline");
  app.add_flag("--accept-all", arguments->acceptAll, "so does what differs at all");
  app.add_option("--filter", arguments->filter, "only jobs whose name contains this")->type_name("TEXT");
  app.add_option("--shard", arguments->shard, "only each N-th job from the I-th on, for many machines (1/1)")
      ->type_name("I/N");
  app.add_option("--merge", arguments->merge, "instead of a suite: results of shards, to make one report of")
      ->type_name("DIR");
  app.add_option("-j,--processes", arguments->processes, "processes beside each other (as many as cores, at most 4)")
      ->type_name("N")
      ->check(CLI::Range(1, 256));
  app.add_option("--timeout", arguments->timeout, "seconds that a job may take (120)")
      ->type_name("S")
      ->check(numberIn(1e-3, 1e6), "FLOAT in [0.001 - 1e+06]");
  app.add_option("--shader-dir", arguments->shaderDir, "reads shaders from here instead of the embedded ones")
      ->type_name("DIR");
  app.add_flag("--no-cache", arguments->noCache, "neither read nor write the cache of compiled shaders");
  addNoSandbox(app, arguments->noSandbox);
  app.add_flag("--worker", arguments->worker, "renders jobs as they are asked for")->group("");
  return [arguments] { return runRegress(*arguments); };
}

}  // namespace facet::commands
