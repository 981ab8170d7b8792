#include "base/parallel.hpp"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <new>
#include <system_error>
#include <thread>
#include <vector>

namespace facet {

void parallelFor(size_t count, const std::function<void(size_t)>& work) {
  const size_t threadCount = std::min<size_t>(count, std::max(1u, std::thread::hardware_concurrency()));
  std::atomic<size_t> next = 0;
  std::mutex mutex;
  std::exception_ptr thrown;
  const auto run = [&] {
    try {
      for (size_t i = next++; i < count; i = next++) work(i);
    } catch (...) {
      next = count;
      const std::lock_guard lock(mutex);
      thrown = std::current_exception();
    }
  };
  {
    std::vector<std::jthread> threads;
    try {
      for (size_t t = 1; t < threadCount; ++t) threads.emplace_back(run);
    } catch (const std::system_error&) {  // no more threads, or no memory for them: those that there are do it
    } catch (const std::bad_alloc&) {
    }
    run();
  }
  if (thrown) std::rethrow_exception(thrown);
}

void lowerThreadPriority() {
  setpriority(PRIO_PROCESS, static_cast<id_t>(gettid()), 10);  // Linux: of the thread alone
}

}  // namespace facet
