#include "base/process_pool.hpp"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <optional>
#include <thread>
#include <utility>

#include "base/interrupt.hpp"

extern char** environ;

namespace facet {

namespace {

using Clock = std::chrono::steady_clock;

class Descriptor {
 public:
  Descriptor() = default;
  explicit Descriptor(int fd) : fd_(fd) {}
  Descriptor(Descriptor&& other) noexcept : fd_(std::exchange(other.fd_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(fd_, other.fd_);
    return *this;
  }
  ~Descriptor() {
    if (fd_ >= 0) close(fd_);
  }
  int get() const { return fd_; }

 private:
  int fd_ = -1;
};

struct Pipe {
  Descriptor read, write;
};

std::optional<Pipe> makePipe() {
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) return std::nullopt;
  return Pipe{Descriptor(ends[0]), Descriptor(ends[1])};
}

// True where it has ended, and been waited for, by then.
bool endsWithin(pid_t pid, double seconds) {
  const Clock::time_point end =
      Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
  for (auto step = std::chrono::microseconds(100);; step = std::min(2 * step, std::chrono::microseconds(20'000))) {
    if (waitpid(pid, nullptr, WNOHANG) != 0) return true;
    if (Clock::now() > end) return false;
    std::this_thread::sleep_for(step);
  }
}

struct Process {
  pid_t pid = -1;
  Descriptor in, out, err;  // our ends
  std::string answer, words;
  std::optional<size_t> task;
  Clock::time_point start;

  Process() = default;
  Process(Process&& other) noexcept { *this = std::move(other); }
  Process& operator=(Process&& other) noexcept {
    std::swap(pid, other.pid);
    std::swap(in, other.in), std::swap(out, other.out), std::swap(err, other.err);
    std::swap(answer, other.answer), std::swap(words, other.words);
    std::swap(task, other.task), std::swap(start, other.start);
    return *this;
  }
  // A process without a task ends by itself once its input does; one with a task is killed, and left behind where the
  // kernel does not let it die, as in a driver that hangs.
  ~Process() {
    if (pid < 0) return;
    in = Descriptor();
    if (!task && endsWithin(pid, 10)) return;
    kill(pid, SIGKILL);
    endsWithin(pid, 2);
  }
};

Result<Process> startProcess(const std::vector<std::string>& command) {
  const auto failed = [&](int error) {
    return fail(command.front(), "", std::string("cannot be started: ") + std::strerror(error),
                "see whether memory and processes suffice");
  };
  std::optional<Pipe> in = makePipe(), out = makePipe(), err = makePipe();
  if (!in || !out || !err) return failed(errno);
  std::vector<char*> arguments;
  for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, in->read.get(), 0);
  posix_spawn_file_actions_adddup2(&actions, out->write.get(), 1);
  posix_spawn_file_actions_adddup2(&actions, err->write.get(), 2);
  Process process;
  const int error = posix_spawn(&process.pid, arguments[0], &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (error != 0) {
    process.pid = -1;
    return failed(error);
  }
  process.in = std::move(in->write), process.out = std::move(out->read), process.err = std::move(err->read);
  fcntl(process.err.get(), F_SETFL, O_NONBLOCK);
  return process;
}

double secondsSince(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

// Appends what is there; false at the end of the stream.
bool readSome(const Descriptor& from, std::string& text) {
  char buffer[4096];
  const ssize_t n = read(from.get(), buffer, sizeof buffer);
  if (n > 0) text.append(buffer, static_cast<size_t>(n));
  return n > 0 || (n < 0 && (errno == EAGAIN || errno == EINTR));
}

std::string lastLine(std::string text) {
  while (text.ends_with('\n')) text.pop_back();
  return text.substr(text.rfind('\n') + 1);
}

// How the process ended, which is waited for.
int endOf(Process& process) {
  int status = 0;
  waitpid(process.pid, &status, 0);
  process.pid = -1;
  for (std::string before = "-"; before != process.words;) before = process.words, readSome(process.err, process.words);
  return status;
}

std::string describeEnd(int status, const std::string& words) {
  std::string text;
  if (WIFSIGNALED(status))
    text = "ended by signal " + std::to_string(WTERMSIG(status)) + " (" + strsignal(WTERMSIG(status)) + ")";
  else
    text = "ended with status " + std::to_string(WEXITSTATUS(status));
  const std::string last = lastLine(words);
  return last.empty() ? text : text + ": " + last;
}

class Pool {
 public:
  Pool(const PoolOptions& options, const std::vector<std::string>& tasks,
       const std::function<void(size_t, const TaskOutcome&)>& done)
      : options_(options), tasks_(tasks), done_(done) {}

  Result<void> run() {
    const size_t wanted = std::min(tasks_.size(), static_cast<size_t>(std::max(1, options_.processes)));
    while (ended_ < tasks_.size()) {
      if (const int signal = interruptedBy()) return fail({}, {}, "ended by " + signalName(signal));
      while (processes_.size() < wanted && next_ < tasks_.size()) {
        Result<Process> started = startProcess(options_.command);
        if (!started) return tl::unexpected(started.error());
        processes_.push_back(std::move(*started));
        give(processes_.back());
      }
      if (Result<void> r = listen(); !r) return r;
    }
    return {};
  }

 private:
  // The next task, if there is one.
  void give(Process& process) {
    process.task.reset();
    if (next_ == tasks_.size()) return;
    process.task = next_++;
    process.start = Clock::now();
    process.words.clear();
    const std::string line = tasks_[*process.task] + "\n";
    // A process that is already gone is noticed when its output ends.
    for (size_t at = 0; at < line.size();) {
      const ssize_t n = write(process.in.get(), line.data() + at, line.size() - at);
      if (n < 0 && errno == EINTR) continue;
      if (n <= 0) break;
      at += static_cast<size_t>(n);
    }
  }

  void end(Process& process, TaskOutcome outcome) {
    outcome.milliseconds = 1e3 * secondsSince(process.start);
    ++ended_;
    done_(*process.task, outcome);
  }

  // One round of waiting for output or the next deadline.
  Result<void> listen() {
    std::vector<pollfd> watched;
    double seconds = options_.secondsPerTask;
    for (const Process& process : processes_) {
      watched.push_back({process.out.get(), POLLIN, 0});
      watched.push_back({process.err.get(), POLLIN, 0});
      if (process.task) seconds = std::min(seconds, options_.secondsPerTask - secondsSince(process.start));
    }
    poll(watched.data(), watched.size(), static_cast<int>(1e3 * std::clamp(seconds, 0.0, 3600.0)) + 1);
    std::vector<size_t> gone;
    for (size_t i = 0; i < processes_.size(); ++i) {
      Process& process = processes_[i];
      if (watched[2 * i + 1].revents != 0) readSome(process.err, process.words);
      const bool open = watched[2 * i].revents == 0 || readSome(process.out, process.answer);
      if (const size_t line = process.answer.find('\n'); process.task && line != std::string::npos) {
        end(process, {process.answer.substr(0, line), {}, 0});
        process.answer.erase(0, line + 1);
        give(process);
      } else if (!open) {
        const int status = endOf(process);
        if (WIFEXITED(status) && WEXITSTATUS(status) == options_.hopelessStatus)
          return fail({}, {}, lastLine(process.words));
        if (process.task) end(process, {{}, describeEnd(status, process.words), 0});
        process.task.reset();
        gone.push_back(i);
      } else if (process.task && secondsSince(process.start) > options_.secondsPerTask) {
        char limit[32];
        std::snprintf(limit, sizeof limit, "%g", options_.secondsPerTask);
        end(process, {{}, std::string("took longer than ") + limit + " s", 0});
        gone.push_back(i);  // killed, because it still has its task
      }
    }
    for (; !gone.empty(); gone.pop_back()) processes_.erase(processes_.begin() + static_cast<ptrdiff_t>(gone.back()));
    return {};
  }

  const PoolOptions& options_;
  const std::vector<std::string>& tasks_;
  const std::function<void(size_t, const TaskOutcome&)>& done_;
  std::vector<Process> processes_;
  size_t next_ = 0, ended_ = 0;
};

}  // namespace

Result<void> distribute(const PoolOptions& options, const std::vector<std::string>& tasks,
                        const std::function<void(size_t, const TaskOutcome&)>& done) {
  // Writing to a process that has ended is an error like any other, not the end of us.
  struct sigaction ignore {};
  struct sigaction before {};
  ignore.sa_handler = SIG_IGN;
  sigaction(SIGPIPE, &ignore, &before);
  const Result<void> result = Pool(options, tasks, done).run();
  sigaction(SIGPIPE, &before, nullptr);
  return result;
}

std::string ownProgram() {
  std::error_code error;
  const std::filesystem::path path = std::filesystem::read_symlink("/proc/self/exe", error);
  return error ? "/proc/self/exe" : path.string();
}

}  // namespace facet
