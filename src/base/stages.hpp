#pragma once

#include <sys/resource.h>

#include <chrono>
#include <ctime>
#include <string>
#include <vector>

namespace facet {

// Where the time of a task went: wall and CPU milliseconds of the whole process by named stage, and how far its memory
// had grown at the stage's end.
struct Stage {
  std::string name;
  double wallMs = 0, cpuMs = 0, peakMB = 0;
};

class Stages {
 public:
  // Books the time since the previous mark (or since construction) under the name; the same name adds up.
  void mark(const std::string& name) {
    const auto now = std::chrono::steady_clock::now();
    const double cpu = cpuMilliseconds();
    Stage& stage = find(name);
    stage.wallMs += std::chrono::duration<double, std::milli>(now - wall_).count();
    stage.cpuMs += cpu - cpu_;
    stage.peakMB = peakMegabytes();
    wall_ = now;
    cpu_ = cpu;
  }
  const std::vector<Stage>& all() const { return stages_; }

  static double peakMegabytes() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_maxrss) / 1024;
  }

 private:
  static double cpuMilliseconds() {
    timespec t{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return static_cast<double>(t.tv_sec) * 1e3 + static_cast<double>(t.tv_nsec) * 1e-6;
  }
  Stage& find(const std::string& name) {
    for (Stage& stage : stages_)
      if (stage.name == name) return stage;
    return stages_.emplace_back(Stage{name, 0, 0, 0});
  }

  std::chrono::steady_clock::time_point wall_ = std::chrono::steady_clock::now();
  double cpu_ = cpuMilliseconds();
  std::vector<Stage> stages_;
};

}  // namespace facet
