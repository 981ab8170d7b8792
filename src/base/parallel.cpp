#include "base/parallel.hpp"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <thread>
#include <vector>

namespace facet {

void parallelFor(size_t count, const std::function<void(size_t)>& work) {
  const size_t threadCount = std::min<size_t>(count, std::max(1u, std::thread::hardware_concurrency()));
  std::atomic<size_t> next = 0;
  const auto run = [&] {
    for (size_t i = next++; i < count; i = next++) work(i);
  };
  std::vector<std::jthread> threads;
  for (size_t t = 1; t < threadCount; ++t) threads.emplace_back(run);
  run();
}

void lowerThreadPriority() {
  setpriority(PRIO_PROCESS, static_cast<id_t>(gettid()), 10);  // Linux: of the thread alone
}

}  // namespace facet
