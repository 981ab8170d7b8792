#pragma once

#include <chrono>
#include <functional>
#include <future>
#include <optional>
#include <vector>

#include "base/parallel.hpp"

namespace facet::view {

// The newest of several tasks of a kind. Tasks must not throw.
template <class T>
class Latest {
 public:
  void start(std::function<T()> task) {
    if (current_.valid()) superseded_.push_back(std::move(current_));
    current_ = std::async(std::launch::async, [task = std::move(task)] {
      lowerThreadPriority();
      return task();
    });
    std::erase_if(superseded_, isReady);  // those still running are waited for at the end of the program
  }
  bool running() const { return current_.valid(); }
  // Nobody waits for it any more.
  void forget() {
    if (current_.valid()) superseded_.push_back(std::move(current_));
    std::erase_if(superseded_, isReady);
  }
  // The newest task's result, once, as soon as it is there; wait: waits for it.
  std::optional<T> take(bool wait = false) {
    if (!current_.valid() || !(wait || isReady(current_))) return std::nullopt;
    return current_.get();
  }

 private:
  static bool isReady(const std::future<T>& future) {
    return future.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
  }
  std::future<T> current_;
  std::vector<std::future<T>> superseded_;
};

}  // namespace facet::view
