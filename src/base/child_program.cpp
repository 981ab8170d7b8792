#include "base/child_program.hpp"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>

extern char** environ;

namespace facet {

int startProgram(const std::vector<std::string>& words, const ChildStreams& streams) {
  std::vector<char*> arguments;
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  if (posix_spawn_file_actions_init(&actions) != 0) return -ENOMEM;
  const auto connect = [&](int from, int to, int flags) {
    if (from >= 0)
      posix_spawn_file_actions_adddup2(&actions, from, to);
    else
      posix_spawn_file_actions_addopen(&actions, to, "/dev/null", flags, 0);
  };
  connect(streams.input, STDIN_FILENO, O_RDONLY);
  connect(streams.output, STDOUT_FILENO, O_WRONLY);
  if (streams.errors.empty())
    connect(-1, STDERR_FILENO, O_WRONLY);
  else
    posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, streams.errors.c_str(), O_WRONLY | O_CREAT | O_TRUNC,
                                     0600);
  pid_t process = -1;
  const int problem = posix_spawnp(&process, arguments[0], &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  return problem == 0 ? process : -problem;
}

void endProgram(int process) {
  ::kill(process, SIGTERM);
  waitForProgram(process);
}

std::optional<int> endedProgram(int process) {
  int status = -1;
  const int ended = ::waitpid(process, &status, WNOHANG);
  return ended == 0 || (ended < 0 && errno == EINTR) ? std::nullopt : std::optional(status);
}

int waitForProgram(int process) {
  int status = -1;
  while (::waitpid(process, &status, 0) < 0 && errno == EINTR) {
  }
  return status;
}

}  // namespace facet
